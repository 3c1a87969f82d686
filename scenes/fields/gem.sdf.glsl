// A cut stone: eight sides, a table on top, crown and pavilion in two rows of facets. An intersection
// of half spaces, so the distance is exact outside of edges and never too long.
// bounds[-1.05, -0.95, -1.05,  1.05, 0.55, 1.05]
uniform float table;     // slider[0.1, 0.42, 0.6] Height of the table
uniform float pavilion;  // slider[35.0, 41.0, 50.0] Slope of the lower facets, degrees

// Distance to the facets that lean by `slope` degrees and touch the girdle of radius 1 at `height`.
float facets(vec3 p, float slope, float height, float turn) {
    float sector = 0.78539816;
    float angle = atan(p.z, p.x) + turn;
    angle = mod(angle + 0.5 * sector, sector) - 0.5 * sector;
    float outwards = length(p.xz) * cos(angle) - 1.0;
    float s = radians(slope);
    return outwards * sin(abs(s)) + (p.y - height) * sign(s) * cos(s);
}

float sdf(vec3 p) {
    float d = facets(p, 90.0, 0.0, 0.0);
    d = max(d, p.y - table);
    d = max(d, max(facets(p, 36.0, 0.06, 0.0), facets(p, 46.0, 0.06, 0.39269908)));
    d = max(d, facets(p, -pavilion, -0.06, 0.0));
    return max(d, facets(p, -pavilion - 4.0, -0.06, 0.39269908));
}
