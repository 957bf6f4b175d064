using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Sessions.Roads;

/// <summary>The positions of a link's ends in whole millimetres: the same in every file of the same roads.</summary>
internal readonly record struct LinkEnds((long X, long Y, long Z) From, (long X, long Y, long Z) To)
{
    private const double MillimetresPerMetre = 1000;

    public static LinkEnds Of(Vector3D from, Vector3D to) => new(Rounded(from), Rounded(to));

    public static LinkEnds Of(RoadNetwork network, RoadLink link) => Of(network.Nodes[link.From].Position, network.Nodes[link.To].Position);

    private static (long X, long Y, long Z) Rounded(Vector3D place) => (Rounded(place.X), Rounded(place.Y), Rounded(place.Z));

    private static long Rounded(double metres) => (long)Math.Round(metres * MillimetresPerMetre);
}
