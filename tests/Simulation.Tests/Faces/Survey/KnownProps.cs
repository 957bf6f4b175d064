using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Faces.Survey;

/// <summary>Props of known faces.</summary>
internal static class KnownProps
{
    private const double Thickness = 0.012;
    private static readonly Rgb Grey = new(128, 128, 128);

    public static IReadOnlyDictionary<string, Prop> All { get; } =
        new Dictionary<string, Prop>
        {
            ["plate"] = Signs(false, Plate(0, -0.06, 2.3, [(-0.3, -0.38), (0.3, -0.38), (0.3, 0.38), (-0.3, 0.38)])),
            ["octagon"] = Signs(false, Plate(0, -0.06, 2.3, Regular(8, 0.4, Math.PI / 8))),
            ["triangle"] = Signs(false, Plate(0, -0.06, 2.3, Regular(3, 0.5, -Math.PI / 2))),
            ["diamond"] = Signs(false, Plate(0, -0.06, 2.35, Regular(4, 0.54, 0))),
            ["beside"] = Signs(false, Plate(0.35, -0.06, 2.2, [(-0.45, -0.2), (0.45, -0.2), (0.45, 0.2), (-0.45, 0.2)])),
            ["ahead"] = Signs(true, Plate(0, 0.06, 2.3, [(-0.4, -0.3), (0.4, -0.3), (0.4, 0.3), (-0.4, 0.3)])),
            ["two"] = Signs(
                false,
                Plate(0, -0.06, 1.7, [(-0.3, -0.15), (0.3, -0.15), (0.3, 0.15), (-0.3, 0.15)]),
                Plate(0, -0.06, 2.4, Regular(8, 0.4, Math.PI / 8))
            ),
            ["coarse"] = Coarse(),
            ["prop_traffic_01a"] = Light("prop_traffic_01a"),
            ["prop_traffic_01b"] = Light("prop_traffic_01b"),
            ["prop_traffic_01d"] = Light("prop_traffic_01d"),
            ["prop_traffic_03a"] = Light("prop_traffic_03a"),
        };

    private static Prop Signs(bool ahead, params Vector3D[][] plates)
    {
        var builder = new MeshBuilder();
        var faces = new List<(Vector3D, Vector3D, Facing)>();
        foreach (Vector3D[] plate in plates)
        {
            builder.AddPrism(plate, new Vector3D(0, ahead ? -Thickness : Thickness, 0), Grey);
            faces.Add(
                (
                    new(plate.Min(c => c.X), plate[0].Y, plate.Min(c => c.Z)),
                    new(plate.Max(c => c.X), plate[0].Y, plate.Max(c => c.Z)),
                    ahead ? Facing.Front : Facing.Back
                )
            );
        }

        builder.AddCylinder(new(0, 0, 0), new(0, 0, plates.Max(plate => plate.Average(c => c.Z))), 0.035, 0.035, 8, Grey);
        return new Prop(builder.Build(), [], faces);
    }

    /// <summary>Rays hit boxes around post and plate where an octagon on a pipe is visible.</summary>
    private static Prop Coarse() =>
        new(
            new MeshBuilder()
                .AddBox(new(-0.05, -0.05, 0), new(0.05, 0.05, 2.3), Grey)
                .AddBox(new(-0.37, -0.07, 1.93), new(0.37, -0.04, 2.67), Grey)
                .Build(),
            [],
            [(new(-0.37, -0.07, 1.93), new(0.37, -0.07, 2.67), Facing.Back)]
        );

    /// <summary>The bones lie in the middles of the heads; of a head, the front is compared.</summary>
    private static Prop Light(string name)
    {
        (Vector3D Min, Vector3D Max)[] heads = [.. SignalModels.Heads(name)];
        return new Prop(
            ModelCatalogue.Shared[name].Mesh,
            [.. heads.Select(head => (head.Min + head.Max) * 0.5)],
            [.. heads.Select(head => (head.Min, head.Max with { Y = head.Min.Y }, Facing.Back))]
        );
    }

    private static Vector3D[] Plate(double x, double y, double z, IEnumerable<(double Right, double Up)> outline) =>
        [.. outline.Select(corner => new Vector3D(x + corner.Right, y, z + corner.Up))];

    private static IEnumerable<(double Right, double Up)> Regular(int count, double radius, double turn) =>
        Enumerable
            .Range(0, count)
            .Select(i => turn + (2 * Math.PI * i / count))
            .Select(angle => (radius * Math.Cos(angle), radius * Math.Sin(angle)));
}
