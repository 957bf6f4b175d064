using System.Collections.Generic;
using System.IO;
using System.Text;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Semantics;

namespace Harvester.Datasets.Exports.Formats.Kitti;

/// <summary>Labels of points as in SemanticKITTI: the class in the lower 16 bits, the id of the object in the upper ones.</summary>
internal static class SemanticKittiLabels
{
    private const int InstanceShift = 16;
    private const uint OtherObject = 99;

    private static readonly Dictionary<SemanticClass, uint> Ids = new()
    {
        [SemanticClass.None] = 0,
        [SemanticClass.Sky] = 0,
        [SemanticClass.Car] = 10,
        [SemanticClass.Bicycle] = 11,
        [SemanticClass.Bus] = 13,
        [SemanticClass.Motorcycle] = 15,
        [SemanticClass.Truck] = 18,
        [SemanticClass.Trailer] = 20,
        [SemanticClass.Pedestrian] = 30,
        [SemanticClass.Road] = 40,
        [SemanticClass.Pavement] = 48,
        [SemanticClass.Water] = 49,
        [SemanticClass.Building] = 50,
        [SemanticClass.Fence] = 51,
        [SemanticClass.LaneMarking] = 60,
        [SemanticClass.Vegetation] = 70,
        [SemanticClass.Terrain] = 72,
        [SemanticClass.Pole] = 80,
        [SemanticClass.Sign] = 81,
    };

    /// <summary>The classes of objects that move: SemanticKITTI has none for a two-wheeler without its rider.</summary>
    private static readonly Dictionary<SemanticClass, uint> MovingIds = new()
    {
        [SemanticClass.Car] = 252,
        [SemanticClass.Bicycle] = 253,
        [SemanticClass.Pedestrian] = 254,
        [SemanticClass.Motorcycle] = 255,
        [SemanticClass.Bus] = 257,
        [SemanticClass.Truck] = 258,
        [SemanticClass.Trailer] = 259,
    };

    /// <summary>Numbers that a label can have as its class.</summary>
    public static IReadOnlyCollection<uint> Classes { get; } = [.. Ids.Values, .. MovingIds.Values, OtherObject];

    /// <summary>The class of a label.</summary>
    public static uint ClassOf(uint label) => label & ((1u << InstanceShift) - 1);

    /// <summary>Writes the labels of points, four bytes each.</summary>
    /// <param name="stream">Receives the labels.</param>
    /// <param name="points">The points.</param>
    /// <param name="moving">The ids of the objects that move.</param>
    public static void Write(Stream stream, IEnumerable<LidarPoint> points, IReadOnlySet<int> moving)
    {
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        foreach (LidarPoint point in points)
        {
            uint id = moving.Contains(point.ObjectId) && MovingIds.TryGetValue(point.Class, out uint mover) ? mover
                : Ids.GetValueOrDefault(point.Class, OtherObject);
            writer.Write(((uint)point.ObjectId << InstanceShift) | id);
        }
    }
}
