using Harvester.Geometry.Roads;

namespace Harvester.Sessions.Roads;

/// <summary>
/// The project's road file: comma-separated lines, first all nodes, then all links, which refer to nodes by their index from 0, then the
/// surveyed edges, which refer to links by index. The last line has the numbers of nodes and links, so that a truncated file is detected.
/// </summary>
public static class RoadCsv
{
    /// <summary>The first line of every such file; the number is the version of the format.</summary>
    public const string FirstLine = "harvester roads,1";

    /// <summary>The fields of a node's line.</summary>
    public const string NodeColumns = "#node,area,number,x,y,z,street,flags,speed,density";

    /// <summary>The fields of a link's line; the length is for readers of the file and is ignored when reading.</summary>
    public const string LinkColumns = "#link,from,to,lanesForward,lanesBackward,medianWidth,flags,length";

    /// <summary>The fields of an edge's line; <c>end</c> is the end of the link beside which it lies.</summary>
    public const string EdgeColumns = "#edge,link,end,x,y,z";

    /// <summary>Names of the two ends of a link in an edge's line.</summary>
    internal const string Start = "from";
    internal const string End = "to";

    /// <summary>Decimals of a metre in the file: enough for the positions of every source, including half steps of 1/64 m.</summary>
    internal const int Decimals = 6;

    internal static readonly FlagNames<RoadNodeFlags> NodeFlags = new();

    internal static readonly FlagNames<RoadLinkFlags> LinkFlags = new();

    internal static string NameOf(RoadSpeed speed) =>
        speed switch
        {
            RoadSpeed.Slow => "slow",
            RoadSpeed.Fast => "fast",
            RoadSpeed.Faster => "faster",
            _ => "normal",
        };
}
