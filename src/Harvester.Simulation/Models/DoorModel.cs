using System.Collections.Concurrent;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The open front door of a vehicle: a plate that stands out at right angles.</summary>
internal static class DoorModel
{
    /// <summary>How far an open door stands out, metres.</summary>
    public const double Reach = 0.95;

    private const double Thickness = 0.06;

    /// <summary>
    /// Its hinges are at this fraction of the vehicle's length, from its rear; its lower and upper edge at these of its height.
    /// </summary>
    private const double Hinge = 0.66;
    private const double Lower = 0.2;
    private const double Upper = 0.92;

    private static readonly ConcurrentDictionary<(string Model, int Side), Mesh> Meshes = new();
    private static readonly Rgb Inside = new(46, 46, 50);

    /// <summary>The mesh of a door, in the frame of the vehicle's model.</summary>
    /// <param name="model">The vehicle.</param>
    /// <param name="side">-1 for the left side, 1 for the right.</param>
    public static Mesh MeshOf(Model model, int side) => Meshes.GetOrAdd((model.Name, side), _ => Build(model, side));

    /// <summary>The rectangle of a vehicle with its open door.</summary>
    public static (Vector3D Min, Vector3D Max) ExtentsOf(Model model, int side) =>
        side < 0 ? (model.Min with { X = model.Min.X - Reach }, model.Max) : (model.Min, model.Max with { X = model.Max.X + Reach });

    private static Mesh Build(Model model, int side)
    {
        double at = model.Min.Y + (Hinge * (model.Max.Y - model.Min.Y));
        double height = model.Max.Z - model.Min.Z;
        double root = side < 0 ? model.Min.X : model.Max.X;
        double tip = root + (side * Reach);
        return new MeshBuilder()
            .AddBox(
                new Vector3D(Math.Min(root, tip), at, model.Min.Z + (Lower * height)),
                new Vector3D(Math.Max(root, tip), at + Thickness, model.Min.Z + (Upper * height)),
                Inside
            )
            .Build();
    }
}
