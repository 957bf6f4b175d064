using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A street lamp or a headlight.</summary>
/// <param name="Position">Metres, world.</param>
/// <param name="Direction">Unit vector along the middle of its cone.</param>
/// <param name="ConeCosine">Cosine of the cone's half angle; -1 shines in all directions.</param>
/// <param name="RangeMetres">Distance at which its light has faded to zero, metres.</param>
/// <param name="Colour">Colour of a white surface close to it.</param>
public readonly record struct LightSource(Vector3D Position, Vector3D Direction, double ConeCosine, double RangeMetres, Rgb Colour)
{
    /// <summary>Its light close to it, as a multiple of its colour.</summary>
    public double Strength { get; init; } = 1.6;

    /// <summary>
    /// The fraction of its light that surfaces show which it grazes: an even surface would show none, but roads are rough.
    /// </summary>
    public double GrazingFraction { get; init; } = 0.25;

    /// <summary>Nearer than this its light is weaker, metres: headlights shine above the road close before a car.</summary>
    public double NearestMetres { get; init; }

    /// <summary>A street lamp, which shines down and around.</summary>
    public static LightSource StreetLamp(Vector3D position) => new(position, new(0, 0, -1), 0.15, 34, new(255, 200, 132)) { Strength = 2 };

    /// <summary>Both headlights of a vehicle, as one light source between them.</summary>
    public static LightSource Headlights(Vector3D position, Vector3D forward) =>
        new(position, (forward + new Vector3D(0, 0, -0.08)).Normalized(), 0.75, 65, new(255, 244, 214))
        {
            Strength = 2.2,
            GrazingFraction = 0.5,
            NearestMetres = 14,
        };
}
