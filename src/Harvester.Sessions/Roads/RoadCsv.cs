using Harvester.Geometry.Roads;

namespace Harvester.Sessions.Roads;

/// <summary>
/// The project's own file of roads: comma-separated lines, first all nodes, then all links, which name their nodes by their place
/// among the nodes, from 0, then what a survey was told of edges, which name their links so. The last line counts nodes and links, so
/// that a file that was cut off is known as such.
/// </summary>
public static class RoadCsv
{
    /// <summary>The first line of every such file; the number is the version of the format.</summary>
    public const string FirstLine = "harvester roads,1";

    /// <summary>What the fields of a node's line are.</summary>
    public const string NodeColumns = "#node,area,number,x,y,z,street,flags,speed,density";

    /// <summary>What the fields of a link's line are; the length is for readers of the file and is not read back.</summary>
    public const string LinkColumns = "#link,from,to,lanesForward,lanesBackward,medianWidth,flags,length";

    /// <summary>What the fields of an edge's line are; <c>end</c> is the end of the link that it lies beside.</summary>
    public const string EdgeColumns = "#edge,link,end,x,y,z";

    /// <summary>The two ends of a link in an edge's line.</summary>
    internal const string Start = "from";
    internal const string End = "to";

    /// <summary>Decimals of a metre in the file: enough for the positions of every source, with the half steps of 1/64 m.</summary>
    internal const int Decimals = 6;

    internal static readonly FlagNames<RoadNodeFlags> NodeFlags = new();

    internal static readonly FlagNames<RoadLinkFlags> LinkFlags = new();

    internal static string NameOf(RoadSpeed speed) => speed switch
    {
        RoadSpeed.Slow => "slow",
        RoadSpeed.Fast => "fast",
        RoadSpeed.Faster => "faster",
        _ => "normal",
    };
}
