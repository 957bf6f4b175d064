using Harvester.Geometry.Roads;

namespace Harvester.Reports.Maps;

/// <summary>How a kind of road is drawn on a map. The kinds are drawn in this order, the important ones last.</summary>
/// <param name="Name">The kind.</param>
/// <param name="Colour">0xRRGGBB.</param>
/// <param name="Weight">Line width, as a multiple of that of a street.</param>
internal sealed record RoadMapStyle(string Name, int Colour, double Weight)
{
    public static readonly RoadMapStyle Water = new("water", 0x96BEDC, 0.6);

    public static readonly RoadMapStyle NotDrivable = new("not drivable", 0xC8C8C8, 0.5);

    public static readonly RoadMapStyle OffRoad = new("unpaved", 0xB08E62, 0.7);

    public static readonly RoadMapStyle Street = new("street", 0x5A5A5A, 1);

    public static readonly RoadMapStyle OneWay = new("one-way", 0x286EB4, 1);

    public static readonly RoadMapStyle Highway = new("highway", 0xDC7814, 1.6);

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
