using System.Globalization;
using System.Text;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Roads;

/// <summary>Writes the node database as comma-separated values. A vector is three numbers separated by spaces.</summary>
public static class NodeDatabaseWriter
{
    /// <summary>The columns of Figure 22 of the thesis, with its names, followed by columns on their reliability.</summary>
    public const string Columns =
        "nodeId,onMarking,oneWay,leftStart,leftEnd,rightStart,rightEnd,heading,"
        + "lanes,oncomingLanes,laneWidth,laneWidthSource,medianWidth,confidence,junction,node";

    private const int MetreDecimals = 3;
    private const int UnitDecimals = 6;

    /// <summary>Writes all entries.</summary>
    /// <returns>The number of entries.</returns>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static int Write(NodeDatabase database, TextWriter text)
    {
        ArgumentNullException.ThrowIfNull(database);
        ArgumentNullException.ThrowIfNull(text);
        text.Write(Columns + "\n");
        var line = new StringBuilder();
        int count = 0;
        foreach (NodeDatabaseEntry entry in database.Entries())
        {
            line.Clear();
            line.Append(CultureInfo.InvariantCulture, $"{entry.NodeId},{Word(entry.OnMarking)},{Word(entry.OneWay)}");
            Append(line, entry.LeftStart, MetreDecimals);
            Append(line, entry.LeftEnd, MetreDecimals);
            Append(line, entry.RightStart, MetreDecimals);
            Append(line, entry.RightEnd, MetreDecimals);
            Append(line, entry.Heading, UnitDecimals);
            line.Append(CultureInfo.InvariantCulture, $",{entry.Lanes},{entry.OncomingLanes},");
            InvariantNumber.Append(line, entry.LaneWidth, MetreDecimals);
            line.Append(',').Append(Name(entry.LaneWidthSource)).Append(',');
            if (entry.MedianWidth is { } median)
            {
                InvariantNumber.Append(line, median, MetreDecimals);
            }

            line.Append(',');
            InvariantNumber.Append(line, entry.Confidence, MetreDecimals);
            line.Append(CultureInfo.InvariantCulture, $",{Word(entry.IsJunction)},{entry.Node}\n");
            text.Write(line.ToString());
            count++;
        }

        return count;
    }

    private static void Append(StringBuilder line, Vector3D vector, int decimals)
    {
        line.Append(',');
        InvariantNumber.Append(line, vector.X, decimals);
        line.Append(' ');
        InvariantNumber.Append(line, vector.Y, decimals);
        line.Append(' ');
        InvariantNumber.Append(line, vector.Z, decimals);
    }

    private static string Name(LaneWidthSource source) =>
        source switch
        {
            LaneWidthSource.Calibrated => "calibrated",
            LaneWidthSource.NarrowConstant => "narrowConstant",
            LaneWidthSource.Paint => "paint",
            LaneWidthSource.PartlyPaint => "partlyPaint",
            _ => "constant",
        };

    private static string Word(bool value) => value ? "true" : "false";
}
