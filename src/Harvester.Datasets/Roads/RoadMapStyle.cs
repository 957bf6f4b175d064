using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>How a kind of road is drawn on a map; the kinds are drawn in this order, the important ones last.</summary>
/// <param name="Name">The kind.</param>
/// <param name="Red">0 to 255.</param>
/// <param name="Green">0 to 255.</param>
/// <param name="Blue">0 to 255.</param>
/// <param name="Weight">Width of its line, as a multiple of that of a street.</param>
internal sealed record RoadMapStyle(string Name, byte Red, byte Green, byte Blue, double Weight)
{
    public static readonly RoadMapStyle Water = new("water", 150, 190, 220, 0.6);

    public static readonly RoadMapStyle NotDrivable = new("not drivable", 200, 200, 200, 0.5);

    public static readonly RoadMapStyle OffRoad = new("unpaved", 176, 142, 98, 0.7);

    public static readonly RoadMapStyle Street = new("street", 90, 90, 90, 1);

    public static readonly RoadMapStyle OneWay = new("one-way", 40, 110, 180, 1);

    public static readonly RoadMapStyle Highway = new("highway", 220, 120, 20, 1.6);

    public static readonly RoadMapStyle[] InOrder = [Water, NotDrivable, OffRoad, Street, OneWay, Highway];

    public static RoadMapStyle Of(RoadNetwork network, RoadLink link)
    {
        RoadNodeFlags flags = network.Nodes[link.From].Flags & network.Nodes[link.To].Flags;
        return (flags & RoadNodeFlags.Water) != 0 ? Water
            : !RoadContinuations.IsDrivable(network, link) ? NotDrivable
            : (flags & RoadNodeFlags.Highway) != 0 ? Highway
            : (flags & RoadNodeFlags.OffRoad) != 0 ? OffRoad
            : link.IsOneWay ? OneWay
            : Street;
    }
}
