using System.Text;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Kitti;

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
        [SemanticClass.Rider] = 30,
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

    private const uint Bicyclist = 31;
    private const uint Motorcyclist = 32;
    private const uint MovingBicyclist = 253;
    private const uint MovingMotorcyclist = 255;

    /// <summary>The classes of objects that move: SemanticKITTI has none for a two-wheeler without its rider.</summary>
    private static readonly Dictionary<SemanticClass, uint> MovingIds = new()
    {
        [SemanticClass.Car] = 252,
        [SemanticClass.Pedestrian] = 254,
        [SemanticClass.Rider] = 254,
        [SemanticClass.Bus] = 257,
        [SemanticClass.Truck] = 258,
        [SemanticClass.Trailer] = 259,
    };

    /// <summary>Numbers that a label can have as its class.</summary>
    public static IReadOnlyCollection<uint> Classes { get; } =
    [.. Ids.Values, .. MovingIds.Values, Bicyclist, Motorcyclist, MovingBicyclist, MovingMotorcyclist, OtherObject];

    /// <summary>The class of a label.</summary>
    public static uint ClassOf(uint label) => label & ((1u << InstanceShift) - 1);

    /// <summary>
    /// Writes the labels of points, four bytes each. A bicyclist or motorcyclist is a person with the vehicle, under the vehicle's id.
    /// </summary>
    /// <param name="stream">Receives the labels.</param>
    /// <param name="points">The points.</param>
    /// <param name="moving">The ids of the objects that move.</param>
    /// <param name="riders">Who rides what.</param>
    public static void Write(Stream stream, IEnumerable<LidarPoint> points, IReadOnlySet<int> moving, Riders riders)
    {
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        foreach (LidarPoint point in points)
        {
            bool isMoving = moving.Contains(point.ObjectId);
            (int instance, uint id) =
                riders.VehicleOf(point.ObjectId) is { } vehicle ? (vehicle.Id, RiderOf(vehicle.Class, isMoving))
                : riders.Ridden.Contains(point.ObjectId) ? (point.ObjectId, RiderOf(SemanticClasses.ObjectOf(point.Class), isMoving))
                : isMoving && MovingIds.TryGetValue(point.Class, out uint mover) ? (point.ObjectId, mover)
                : (point.ObjectId, Ids.GetValueOrDefault(point.Class, OtherObject));
            writer.Write(((uint)instance << InstanceShift) | id);
        }
    }

    private static uint RiderOf(ObjectClass? vehicle, bool isMoving) =>
        vehicle == ObjectClass.Bicycle
            ? isMoving
                ? MovingBicyclist
                : Bicyclist
            : isMoving
                ? MovingMotorcyclist
                : Motorcyclist;
}
