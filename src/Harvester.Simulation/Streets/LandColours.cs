using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>The colours of the ground beside roads: lots in town, gardens, and fields or dry land outside.</summary>
internal static class LandColours
{
    /// <summary>Slope from which rock shows, metres per metre.</summary>
    private const double Steep = 0.45;

    private const double FieldLength = 110;
    private const double FieldWidth = 70;

    private static readonly Rgb Lot = new(134, 131, 124);
    private static readonly Rgb Garden = new(98, 120, 66);
    private static readonly Rgb Sand = new(184, 160, 118);
    private static readonly Rgb Scrub = new(150, 140, 92);
    private static readonly Rgb Rock = new(132, 118, 98);
    private static readonly Rgb[] Fields =
    [
        Palette.Grass,
        Palette.DryGrass,
        new(172, 156, 92),
        new(88, 118, 56),
        new(122, 100, 74),
        Palette.Grass,
    ];

    /// <summary>The colour of a triangle of the ground.</summary>
    public static Rgb Of(Zone zone, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D normal = (b - a).Cross(c - a).Normalized();
        double slope = Math.Sqrt(Math.Max(0, 1 - (normal.Z * normal.Z))) / Math.Max(Math.Abs(normal.Z), 1e-6);

        // Patches of drier grass, in waves that do not repeat with the grid.
        double dryness = 0.5 + (0.5 * Math.Sin((a.X * 0.037) + (2 * Math.Sin(a.Y * 0.023))));
        Rgb grass = Palette.Grass.Towards(Palette.DryGrass, dryness);
        return zone switch
        {
            Zone.Centre => Lot.Scaled(0.94 + (0.1 * dryness)),
            Zone.Town => grass.Towards(Lot, 0.45),
            Zone.Suburb => Garden.Towards(grass, 0.5),
            _ => slope > Steep ? Rock.Scaled(0.92 + (0.14 * dryness)) : Open(a, grass),
        };
    }

    private static Rgb Open(Vector3D place, Rgb grass)
    {
        double desert = 0.5 + (0.5 * Math.Sin((place.X / 900) + 5.6) * Math.Sin((place.Y / 1100) + 4.5));
        const double dryFrom = 0.68;
        if (desert > dryFrom)
        {
            return Sand.Towards(Scrub, 0.5 + (0.5 * Math.Sin((place.X * 0.051) + (3 * Math.Sin(place.Y * 0.037)))));
        }

        // Fields in rows that are not parallel to the grid.
        int column = (int)Math.Floor(((place.X * 0.9) + (place.Y * 0.44)) / FieldLength);
        int row = (int)Math.Floor(((place.Y * 0.9) - (place.X * 0.44)) / FieldWidth);
        uint hash = (uint)((column * 73856093) ^ (row * 19349663)) * 2654435761;
        return Fields[(int)((hash >> 16) % (uint)Fields.Length)].Towards(grass, 0.35);
    }
}
