using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Faces.Survey;

/// <summary>
/// Signs of every shape, on posts of every radius up to 6 cm that end behind the plate or above it, with plates before and behind the post.
/// </summary>
internal static class SignShapes
{
    private static readonly Rgb Grey = new(128, 128, 128);

    public static IReadOnlyList<string> Outlines { get; } =
    ["rectangle", "octagon", "diamond", "triangle up", "triangle down", "triangle sideways", "turned square"];

    public static IReadOnlyDictionary<string, Prop> Of(string outline, Facing facing)
    {
        // The sizes are drawn once and for all: the same seed gives the same signs.
        var random = new Random(16);
        var signs = new Dictionary<string, Prop>();
        foreach (double radius in new[] { 0.01, 0.02, 0.03, 0.04, 0.05, 0.06 })
        {
            foreach (double postTop in new[] { 0.5, 0.9, 1.2 })
            {
                double size = 0.4 + (0.6 * random.NextDouble());
                double thickness = 0.003 + (0.02 * random.NextDouble());
                double gap = random.Next(2) * 0.03 * random.NextDouble();
                double middle = 1.9 + random.NextDouble();
                double beside = random.Next(2) * 0.1 * (random.NextDouble() - 0.5);
                string name = string.Create(
                    CultureInfo.InvariantCulture,
                    $"{outline} {size:0.000} m, {facing}, post {radius:0.00} m to {postTop:0.0}, plate {thickness:0.0000} m, gap "
                        + $"{gap:0.0000} m, at {middle:0.000} m"
                );
                signs.Add(
                    name,
                    Sign([.. Corners(outline, size / 2)], facing, radius, postTop, thickness, gap, new Vector3D(beside, 0, middle))
                );
            }
        }

        return signs;
    }

    private static Prop Sign(
        (double Right, double Up)[] outline,
        Facing facing,
        double radius,
        double postTop,
        double thickness,
        double gap,
        Vector3D middle
    )
    {
        int side = facing == Facing.Front ? 1 : -1;
        double y = side * (radius + gap + thickness);
        Vector3D[] plate = [.. outline.Select(corner => middle + new Vector3D(corner.Right, y, corner.Up))];
        (double bottom, double top) = (plate.Min(corner => corner.Z), plate.Max(corner => corner.Z));
        return new Prop(
            new MeshBuilder()
                .AddPrism(plate, new Vector3D(0, -side * thickness, 0), Grey)
                .AddCylinder(Vector3D.Zero, new(0, 0, bottom + (postTop * (top - bottom))), radius, radius, 16, Grey)
                .Build(),
            [],
            [(new(plate.Min(corner => corner.X), y, bottom), new(plate.Max(corner => corner.X), y, top), facing)]
        );
    }

    private static IEnumerable<(double Right, double Up)> Corners(string outline, double radius) =>
        outline switch
        {
            "rectangle" => [(-0.7 * radius, -radius), (0.7 * radius, -radius), (0.7 * radius, radius), (-0.7 * radius, radius)],
            "octagon" => Regular(8, radius, Math.PI / 8),
            "diamond" => Regular(4, radius, 0),
            "triangle up" => Regular(3, radius, Math.PI / 2),
            "triangle down" => Regular(3, radius, -Math.PI / 2),
            "triangle sideways" => Regular(3, radius, 0),
            "turned square" => Regular(4, radius, Math.PI / 9),
            _ => throw new ArgumentOutOfRangeException(nameof(outline), outline, "No such outline."),
        };

    private static IEnumerable<(double Right, double Up)> Regular(int count, double radius, double turn) =>
        Enumerable
            .Range(0, count)
            .Select(i => turn + (2 * Math.PI * i / count))
            .Select(angle => (radius * Math.Cos(angle), radius * Math.Sin(angle)));
}
