using System.Xml.Linq;

namespace Harvester.Exports.Tests.Maps;

/// <summary>A lanelet. Its borders may run either way in the file; here both run in its direction.</summary>
internal sealed class Lanelet2Lane
{
    private readonly Lanelet2File _file;
    private readonly long[] _leftInFile;
    private readonly long[] _rightInFile;

    public Lanelet2Lane(Lanelet2File file, XElement relation)
    {
        (_file, Relation) = (file, relation);
        (LeftWay, RightWay) = (Lanelet2File.Members(relation, "left").Single(), Lanelet2File.Members(relation, "right").Single());
        (_leftInFile, _rightInFile) = (file.NodesOf(LeftWay), file.NodesOf(RightWay));
        (long[] left, long[] right) = ([.. _leftInFile], [.. _rightInFile]);
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

    /// <summary>
    /// The borders as Lanelet2's reader has them. It reverses the left one of the file unless the middle node of the right one, or of two
    /// nodes their middle, lies on its right, and then the right one unless that of the left one lies on its left.
    /// </summary>
    public (long[] Left, long[] Right) AsRead()
    {
        (long[] left, long[] right) = (_leftInFile, _rightInFile);
        left = IsOnLeft(left, MiddleNode(right)) ? [.. left.Reverse()] : left;
        return (left, IsOnLeft(right, MiddleNode(left)) ? right : [.. right.Reverse()]);
    }

    private double[] MiddleNode(long[] nodes) =>
        nodes.Length > 2
            ? Place(nodes[nodes.Length / 2])
            : [.. Place(nodes[0]).Zip(Place(nodes[^1]), static (one, other) => (one + other) / 2)];

    private double[] Place(long node)
    {
        (double x, double y) = _file.Place(node);
        return [x, y, Lanelet2File.Number(Lanelet2File.Tag(_file.Nodes[node], "ele")!)];
    }

    /// <summary>
    /// The side of the piece of a line that is nearest to a place. A place nearest to a node whose two pieces do not agree is on the
    /// outside of the bend.
    /// </summary>
    private bool IsOnLeft(long[] nodes, double[] place)
    {
        double[][] line = [.. nodes.Select(Place)];
        var pieces = Enumerable
            .Range(0, line.Length - 1)
            .Select(i =>
            {
                double[] along = [.. line[i + 1].Zip(line[i], static (to, from) => to - from)];
                double[] to = [.. place.Zip(line[i], static (there, from) => there - from)];
                double part = Math.Clamp(to.Zip(along, static (x, y) => x * y).Sum() / along.Sum(static x => x * x), 0, 1);
                return (Index: i, Part: part, Apart: to.Zip(along, (x, y) => Math.Pow(x - (part * y), 2)).Sum());
            })
            .ToArray();
        (int nearest, double part, _) = pieces.MinBy(piece => piece.Apart);
        bool here = IsLeft(line[nearest], line[nearest + 1], place);
        if (part < 1 || nearest + 2 >= line.Length || IsLeft(line[nearest + 1], line[nearest + 2], place) == here)
        {
            return here;
        }

        return !IsLeft(line[nearest], line[nearest + 1], line[nearest + 2]);
    }

    private static bool IsLeft(double[] from, double[] to, double[] place) =>
        ((to[0] - from[0]) * (place[1] - from[1])) > ((to[1] - from[1]) * (place[0] - from[0]));

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
