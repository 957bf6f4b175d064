using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Sessions.Roads;

/// <summary>
/// The table of measured paint: comma-separated lines. The line of a link names it by the positions of its ends, so that the table can be
/// used with another file of the same roads; the lines painted on the link follow it. Stop lines and crossings follow all links. The last
/// line has the numbers of links, lines and marks, so that a truncated file is detected; without marks it has two numbers.
/// </summary>
public static class PaintCsv
{
    /// <summary>The first line of every such file; the number is the version of the format.</summary>
    public const string FirstLine = "harvester paint,1";

    /// <summary>The fields of a link's line.</summary>
    public const string LinkColumns = "#link,index,fromX,fromY,fromZ,toX,toY,toZ,seenFrom,seenTo";

    /// <summary>The fields of the line of a painted line.</summary>
    public const string LineColumns =
        "#line,index,fromStation,toStation,fromOffset,toOffset,style,colour,width,dashLength,dashPeriod,dashPhase,sigma,images";

    /// <summary>The fields of the line of a stop line or crossing; x, y and z are repeated for each corner.</summary>
    public const string MarkColumns = "#mark,class,sigma,images,x,y,z";

    /// <summary>Fields of a mark before its corners.</summary>
    internal const int MarkFields = 4;

    /// <summary>Decimals of a metre in the file.</summary>
    internal const int Decimals = 4;

    /// <summary>Whether two networks have a link with the same ends.</summary>
    /// <exception cref="ArgumentNullException">A network is null.</exception>
    public static bool SharesLinks(RoadNetwork a, RoadNetwork b)
    {
        if (a is null || b is null)
        {
            throw new ArgumentNullException(a is null ? nameof(a) : nameof(b));
        }

        var ends = new HashSet<LinkEnds>(a.Links.Select(link => LinkEnds.Of(a, link)));
        return b.Links.Any(link => ends.Contains(LinkEnds.Of(b, link)));
    }

    internal static string NameOf(MarkingStyle style) =>
        style switch
        {
            MarkingStyle.Dashed => "dashed",
            MarkingStyle.DoubleSolid => "doubleSolid",
            _ => "solid",
        };

    internal static string NameOf(MarkKind kind) =>
        kind switch
        {
            MarkKind.Crossing => "crossing",
            MarkKind.ArrowStraight => "arrowStraight",
            MarkKind.ArrowLeft => "arrowLeft",
            MarkKind.ArrowRight => "arrowRight",
            _ => "stopLine",
        };

    internal static string NameOf(MarkingColour colour) => colour == MarkingColour.Yellow ? "yellow" : "white";
}
