/* Vertex curvatures (22) and face curvatures (17) in plain C, one thread: what `cargo bench --bench
 * curvature` compares with. Input: int64 vertices, edges, quads; double points[vertices][3],
 * image[vertices][3]; int32 edges[edges][4] (from, to, apex on the left, apex on the right),
 * quads[quads][4]. Writes all H, then all K, to the second file; prints the best of five times. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef double point[3];
typedef int32_t four[4];

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void *get(FILE *f, size_t size, size_t count) {
    void *data = malloc(size * count + 1);
    if (!data || fread(data, size, count, f) != count) exit(2);
    return data;
}

/* Half the cotangent at c of the triangle a, b, c, and the slope of its plane across a-b. */
static inline double half_cot(const double *a, const double *b, const double *c, double *across) {
    double ax = a[0] - c[0], ay = a[1] - c[1], bx = b[0] - c[0], by = b[1] - c[1];
    double det = 1 / (ax * by - ay * bx), az = a[2] - c[2], bz = b[2] - c[2];
    double px = (az * by - bz * ay) * det, py = (ax * bz - bx * az) * det;
    double ex = b[0] - a[0], ey = b[1] - a[1];
    *across = ex * py - ey * px;
    return 0.5 * (ax * bx + ay * by) * det;
}

int main(int argc, char **argv) {
    FILE *f = argc > 2 ? fopen(argv[1], "rb") : NULL, *out = argc > 2 ? fopen(argv[2], "wb") : NULL;
    if (!f || !out) return 2;
    int64_t *n = get(f, 8, 3);
    point *p = get(f, sizeof(point), n[0]), *s = get(f, sizeof(point), n[0]);
    four *edge = get(f, sizeof(four), n[1]), *quad = get(f, sizeof(four), n[2]);
    double *H = malloc(8 * (n[0] + n[2])), *K = malloc(8 * (n[0] + n[2]));
    double *d = malloc(24 * n[0]), best = 1e9;
    for (int run = 0; run < 5 && n[1]; run++) {
        double start = now();
        for (int64_t i = 0; i < 3 * n[0]; i++) d[i] = 0;
        for (int64_t i = 0; i < n[1]; i++) {
            int32_t a = edge[i][0], b = edge[i][1];
            double left, right;
            double w = half_cot(p[a], p[b], p[edge[i][2]], &left);
            w += half_cot(p[b], p[a], p[edge[i][3]], &right);
            double ex = p[b][0] - p[a][0], ey = p[b][1] - p[a][1], rise = p[b][2] - p[a][2];
            double l2 = ex * ex + ey * ey, jump = (left + right) / l2;
            d[3 * a] += 0.5 * jump * rise, d[3 * b] -= 0.5 * jump * rise;
            d[3 * a + 1] += 0.5 * w * rise, d[3 * b + 1] -= 0.5 * w * rise;
            d[3 * a + 2] += 0.25 * w * l2, d[3 * b + 2] += 0.25 * w * l2;
        }
        for (int64_t i = 0; i < n[0]; i++) {
            K[i] = d[3 * i] / d[3 * i + 2];
            H[i] = d[3 * i + 1] / d[3 * i + 2];
        }
        double time = now() - start;
        best = time < best ? time : best;
    }
    for (int run = 0; run < 5 && n[2]; run++) {
        double start = now();
        for (int64_t i = 0; i < n[2]; i++) {
            const double *a = p[quad[i][0]], *b = p[quad[i][1]], *c = p[quad[i][2]], *e = p[quad[i][3]];
            const double *A = s[quad[i][0]], *B = s[quad[i][1]], *C = s[quad[i][2]], *E = s[quad[i][3]];
            double x = c[0] - a[0], y = c[1] - a[1], z = e[0] - b[0], w = e[1] - b[1];
            double X = C[0] - A[0], Y = C[1] - A[1], Z = E[0] - B[0], W = E[1] - B[1];
            double area = x * w - y * z;
            K[i] = (X * W - Y * Z) / area;
            H[i] = 0.5 * (x * W - y * Z + X * w - Y * z) / area;
        }
        double time = now() - start;
        best = time < best ? time : best;
    }
    int64_t count = n[2] ? n[2] : n[0];
    if (fwrite(H, 8, count, out) + fwrite(K, 8, count, out) != 2 * (size_t)count) return 2;
    if (fclose(out)) return 2;
    printf("%.4f\n", best);
    return 0;
}
