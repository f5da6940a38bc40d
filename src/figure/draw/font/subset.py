"""Makes roman.otf: python3 subset.py lmroman10-regular.otf roman.otf; needs fonttools."""

import sys

from fontTools import subset
from fontTools.ttLib import TTFont

source, target = sys.argv[1:]
font = TTFont(source, recalcTimestamp=False)
chosen = subset.Subsetter(subset.Options(layout_features=["kern"], desubroutinize=True, name_IDs=[0, 2, 5]))
chosen.populate(unicodes=[*range(0x20, 0x7F), ord("²"), ord("Σ"), ord("−")])
chosen.subset(font)
notice = "Made of LM Roman 10; what was changed is said in README.md beside this file."
names = {1: "Isogeo Roman", 3: "IsogeoRoman", 4: "Isogeo Roman", 6: "IsogeoRoman", 10: notice}
for identifier, text in names.items():
    font["name"].setName(text, identifier, 3, 1, 0x409)
cff = font["CFF "].cff
cff.fontNames[0] = names[6]
cff.topDictIndex[0].FullName = cff.topDictIndex[0].FamilyName = names[1]
font.save(target)
