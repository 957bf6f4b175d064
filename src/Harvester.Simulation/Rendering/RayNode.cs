using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A node of a <see cref="RayTree"/>: up to eight boxes, coordinate by coordinate, so that one test serves all of them. The boxes have
/// single precision and are rounded outwards; those of unused places are empty, so that no ray hits them.
/// </summary>
internal readonly struct RayNode
{
    /// <summary>Maximum number of boxes.</summary>
    public const int Width = 8;

    /// <param name="boxes">The boxes.</param>
    /// <param name="children">For each box, the number of a node, or the complement of the number of a leaf.</param>
    public RayNode(ReadOnlySpan<Bounds> boxes, ReadOnlySpan<int> children)
    {
        MinX = Vector256.Create(float.PositiveInfinity);
        MinY = MinX;
        MinZ = MinX;
        MaxX = Vector256.Create(float.NegativeInfinity);
        MaxY = MaxX;
        MaxZ = MaxX;
        for (int i = 0; i < boxes.Length; i++)
        {
            (Vector3D min, Vector3D max) = (boxes[i].Min, boxes[i].Max);
            MinX = MinX.WithElement(i, Below(min.X));
            MinY = MinY.WithElement(i, Below(min.Y));
            MinZ = MinZ.WithElement(i, Below(min.Z));
            MaxX = MaxX.WithElement(i, Above(max.X));
            MaxY = MaxY.WithElement(i, Above(max.Y));
            MaxZ = MaxZ.WithElement(i, Above(max.Z));
            Children = Children.WithElement(i, children[i]);
        }
    }

    public Vector256<float> MinX { get; }

    public Vector256<float> MinY { get; }

    public Vector256<float> MinZ { get; }

    public Vector256<float> MaxX { get; }

    public Vector256<float> MaxY { get; }

    public Vector256<float> MaxZ { get; }

    public Vector256<int> Children { get; }

    /// <summary>A number of single precision that is certainly less, also than what rounding has made the coordinate of.</summary>
    private static float Below(double value) => MathF.BitDecrement((float)value);

    private static float Above(double value) => MathF.BitIncrement((float)value);
}
