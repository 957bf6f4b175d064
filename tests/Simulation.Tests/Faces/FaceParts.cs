using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>Splits the shapes of signs and traffic lights, so that the renderer can draw a face under a number of its own.</summary>
internal static class FaceParts
{
    /// <summary>The plane of the sheets of all signs: sheet and paint lie on it and before it, metres.</summary>
    private const double SheetY = -0.05;

    /// <summary>
    /// The middles of the heads as the models have them, by reading the drawing of the models: x and z, and the plane of the housing's
    /// front.
    /// </summary>
    private static readonly Dictionary<string, (double X, double Z, double FrontY)[]> Heads = new()
    {
        ["prop_traffic_01a"] = [(-8, 6.1, -0.3), (-4.5, 6.1, -0.3), (0, 3.1, -0.42)],
        ["prop_traffic_01b"] = [(-5.5, 6.1, -0.3), (0, 3.1, -0.42)],
        ["prop_traffic_01d"] = [(-10.5, 6.1, -0.3), (-7, 6.1, -0.3), (-3.5, 6.1, -0.3), (0, 3.1, -0.42)],
        ["prop_traffic_03a"] = [(0, 2.9, -0.37)],
        ["prop_traffic_03b"] = [(0, 2.9, -0.37)],
    };

    public static Mesh FaceOf(Model sign) => Part(sign.Mesh, IsOnSheet);

    /// <summary>The faces of a model in the order of their numbers, followed by the rest.</summary>
    public static IReadOnlyList<Mesh> Split(Model model, int variant)
    {
        Mesh mesh = model.Variant(variant);
        if (model.Class == ObjectClass.Sign)
        {
            return [Part(mesh, IsOnSheet), Part(mesh, triangle => !IsOnSheet(triangle))];
        }

        (double X, double Z, double FrontY)[] heads = Heads[model.Name];
        return
        [
            .. heads.Select(head => Part(mesh, triangle => IsOnFront(triangle, head))),
            Part(mesh, triangle => !heads.Any(head => IsOnFront(triangle, head))),
        ];
    }

    private static bool IsOnSheet(MeshTriangle triangle) => Corners(triangle).All(corner => corner.Y <= SheetY);

    // The housing is 0.36 m wide and 1.05 m high; lenses and visors stand before its front.
    private static bool IsOnFront(MeshTriangle triangle, (double X, double Z, double FrontY) head) =>
        Corners(triangle)
            .All(corner => corner.Y <= head.FrontY + 1e-9 && Math.Abs(corner.X - head.X) < 0.2 && Math.Abs(corner.Z - head.Z) < 0.55);

    private static Vector3D[] Corners(MeshTriangle triangle) => [triangle.A, triangle.B, triangle.C];

    private static Mesh Part(Mesh mesh, Func<MeshTriangle, bool> belongs) => new(mesh.Triangles.ToArray().Where(belongs));
}
