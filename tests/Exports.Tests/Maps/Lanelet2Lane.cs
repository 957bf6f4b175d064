using System.Xml.Linq;

namespace Harvester.Exports.Tests.Maps;

/// <summary>A lanelet. Its borders may run either way in the file; here both run in its direction.</summary>
internal sealed class Lanelet2Lane
{
    private readonly Lanelet2File _file;

    public Lanelet2Lane(Lanelet2File file, XElement relation)
    {
        (_file, Relation) = (file, relation);
        (LeftWay, RightWay) = (Lanelet2File.Members(relation, "left").Single(), Lanelet2File.Members(relation, "right").Single());
        (long[] left, long[] right) = (file.NodesOf(LeftWay), file.NodesOf(RightWay));
        if (Apart(left[0], right[0]) + Apart(left[^1], right[^1]) > Apart(left[0], right[^1]) + Apart(left[^1], right[0]))
        {
            Array.Reverse(right);
        }

        // Along the left border and back along the right one is clockwise.
        long[] outline = [.. left, .. right.Reverse()];
        if (outline.Select((node, i) => Cross(node, outline[(i + 1) % outline.Length])).Sum() > 0)
        {
            Array.Reverse(left);
            Array.Reverse(right);
        }

        (Left, Right) = (left, right);
    }

    public XElement Relation { get; }

    public string Name => Lanelet2File.Tag(Relation, "name")!;

    public long LeftWay { get; }

    public long RightWay { get; }

    public long[] Left { get; }

    public long[] Right { get; }

    /// <summary>Points of its middle: those of the file, or between points at the same parts of the borders' lengths.</summary>
    public IEnumerable<(double X, double Y)> Middle()
    {
        if (Lanelet2File.Members(Relation, "centerline") is [long way])
        {
            return _file.NodesOf(way).Select(_file.Place);
        }

        return new[] { 0, 0.25, 0.5, 0.75, 1 }.Select(fraction =>
        {
            ((double lx, double ly), (double rx, double ry)) = (At(Left, fraction), At(Right, fraction));
            return ((lx + rx) / 2, (ly + ry) / 2);
        });
    }

    private (double X, double Y) At(long[] nodes, double fraction)
    {
        double wanted = fraction * Enumerable.Range(1, nodes.Length - 1).Sum(i => Apart(nodes[i - 1], nodes[i]));
        for (int i = 1; ; i++)
        {
            double piece = Apart(nodes[i - 1], nodes[i]);
            if (wanted <= piece || i == nodes.Length - 1)
            {
                ((double x, double y), (double toX, double toY)) = (_file.Place(nodes[i - 1]), _file.Place(nodes[i]));
                double part = Math.Min(1, wanted / piece);
                return (x + ((toX - x) * part), y + ((toY - y) * part));
            }

            wanted -= piece;
        }
    }

    private double Apart(long one, long other)
    {
        ((double x, double y), (double otherX, double otherY)) = (_file.Place(one), _file.Place(other));
        return Math.Sqrt(Math.Pow(x - otherX, 2) + Math.Pow(y - otherY, 2));
    }

    private double Cross(long one, long other)
    {
        ((double x, double y), (double otherX, double otherY)) = (_file.Place(one), _file.Place(other));
        return (x * otherY) - (y * otherX);
    }
}
