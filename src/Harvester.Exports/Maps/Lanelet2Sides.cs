using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>
/// Sees to it that Lanelet2 takes the borders of each lanelet for what they are. It does not go by the order of their nodes, but by the
/// side of one border on which the middle node of the other lies, and reverses a border that lies on the wrong one. In sharp turns that
/// may happen to a border that is right: there, nodes are added on the border, until its middle node lies where the sides are plain.
/// </summary>
internal sealed class Lanelet2Sides
{
    /// <summary>The least distance of nodes that are added, metres.</summary>
    private const double MinStep = 0.1;

    /// <summary>Where the middle node is tried, as parts of the border's length.</summary>
    private static readonly double[] Parts = [0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9, 0.05, 0.95];

    private readonly LaneBorders _borders;
    private readonly Dictionary<LaneBorder, List<MapLane>> _lanes = [];

    private Lanelet2Sides(LaneBorders borders) => _borders = borders;

    /// <summary>Adds nodes to borders where it is needed.</summary>
    /// <param name="borders">The borders.</param>
    /// <param name="lanes">The lanes that have them.</param>
    public static void Settle(LaneBorders borders, IEnumerable<MapLane> lanes)
    {
        var sides = new Lanelet2Sides(borders);
        MapLane[] all = [.. lanes];
        foreach (MapLane lane in all)
        {
            sides.Note(borders.LeftOf(lane).Border, lane);
            sides.Note(borders.RightOf(lane).Border, lane);
        }

        foreach (MapLane lane in all.Where(lane => !sides.IsUnderstood(lane, null, null)))
        {
            sides.Settle(lane);
        }
    }

    private void Note(LaneBorder border, MapLane lane)
    {
        if (!_lanes.TryGetValue(border, out List<MapLane>? lanes))
        {
            _lanes.Add(border, lanes = []);
        }

        lanes.Add(lane);
    }

    private void Settle(MapLane lane)
    {
        (LaneBorder left, LaneBorder right) = (_borders.LeftOf(lane).Border, _borders.RightOf(lane).Border);
        List<BorderNode>?[] lefts = [null, .. Variants(left)];
        List<BorderNode>?[] rights = [null, .. Variants(right)];
        foreach ((List<BorderNode>? ofLeft, List<BorderNode>? ofRight) in lefts.SelectMany(_ => rights, (one, other) => (one, other)))
        {
            if (
                IsUnderstood(lane, ofLeft, ofRight)
                && (ofLeft is null || _lanes[left].TrueForAll(other => other == lane || Stays(other, left, ofLeft)))
                && (ofRight is null || _lanes[right].TrueForAll(other => other == lane || Stays(other, right, ofRight)))
            )
            {
                Take(left, ofLeft);
                Take(right, ofRight);
                return;
            }
        }
    }

    /// <summary>Whether a lane is understood with other nodes of a border, or is not in either case.</summary>
    private bool Stays(MapLane lane, LaneBorder border, List<BorderNode> nodes) =>
        IsUnderstood(lane, _borders.LeftOf(lane).Border == border ? nodes : null, _borders.RightOf(lane).Border == border ? nodes : null)
        || !IsUnderstood(lane, null, null);

    private void Take(LaneBorder border, List<BorderNode>? nodes)
    {
        if (nodes is not null)
        {
            border.Nodes = [.. nodes.Select(node => node.Number ?? _borders.AddNode(node.Place))];
        }
    }

    /// <summary>The border with another middle node each.</summary>
    private IEnumerable<List<BorderNode>> Variants(LaneBorder border)
    {
        List<BorderNode> nodes = [.. border.Nodes.Select(node => new BorderNode(node, _borders.Nodes[node]))];
        double length = LengthOf(nodes);
        foreach (double part in Parts)
        {
            (List<BorderNode> before, List<BorderNode> after) = Cut(nodes, part * length);

            // With as many nodes before the middle as after it, it is the middle from either end.
            int more = after.Count - before.Count;
            if (Filled(before, more) is { } start && Filled(after, -more) is { } end)
            {
                yield return [.. start, .. end.Skip(1)];
            }
        }

        // Where the edge of a sharp bend runs back: straight from end to end.
        if (nodes.Count > 2)
        {
            yield return [nodes[0], nodes[^1]];
        }
    }

    private static double LengthOf(List<BorderNode> nodes) =>
        nodes.Skip(1).Zip(nodes, static (one, other) => (one.Place - other.Place).Length).Sum();

    /// <summary>A line in two, with one node in common, which is new unless a node is near.</summary>
    private static (List<BorderNode> Before, List<BorderNode> After) Cut(List<BorderNode> nodes, double station)
    {
        for (int i = 1; i < nodes.Count; i++)
        {
            double piece = (nodes[i].Place - nodes[i - 1].Place).Length;
            if (station <= piece || i == nodes.Count - 1)
            {
                if (piece - station < MinStep && i < nodes.Count - 1)
                {
                    return (nodes[..(i + 1)], nodes[i..]);
                }

                if (station < MinStep && i > 1)
                {
                    return (nodes[..i], nodes[(i - 1)..]);
                }

                Vector3D place = nodes[i - 1].Place + ((nodes[i].Place - nodes[i - 1].Place) * Math.Min(1, station / piece));
                var cut = new BorderNode(null, place);
                return ([.. nodes[..i], cut], [cut, .. nodes[i..]]);
            }

            station -= piece;
        }

        return (nodes, nodes[^1..]);
    }

    /// <summary>A line with a number of nodes more, each where the nodes are farthest apart; null if there is no room for them.</summary>
    private static List<BorderNode>? Filled(List<BorderNode> nodes, int more)
    {
        int[] parts = [.. Enumerable.Repeat(1, nodes.Count - 1)];
        double StepOf(int piece) => (nodes[piece + 1].Place - nodes[piece].Place).Length / parts[piece];
        for (int added = 0; added < more; added++)
        {
            int longest = Enumerable.Range(0, parts.Length).MaxBy(StepOf);
            parts[longest]++;
            if (StepOf(longest) < MinStep)
            {
                return null;
            }
        }

        var filled = new List<BorderNode> { nodes[0] };
        for (int piece = 0; piece < parts.Length; piece++)
        {
            (Vector3D from, Vector3D to) = (nodes[piece].Place, nodes[piece + 1].Place);
            filled.AddRange(
                Enumerable.Range(1, parts[piece] - 1).Select(i => new BorderNode(null, from + ((to - from) * ((double)i / parts[piece]))))
            );
            filled.Add(nodes[piece + 1]);
        }

        return filled;
    }

    /// <summary>Whether Lanelet2 would have both borders in the direction of the lane.</summary>
    private bool IsUnderstood(MapLane lane, List<BorderNode>? ofLeft, List<BorderNode>? ofRight)
    {
        (BorderSide left, BorderSide right) = (_borders.LeftOf(lane), _borders.RightOf(lane));
        Vector3D[] lefts = PlacesOf(left.Border, ofLeft);
        Vector3D[] rights = PlacesOf(right.Border, ofRight);

        // It reverses a left border on whose right the right one's middle is not, and then a right one on whose left the left one's is not.
        bool isLeftReversed = IsLeftOf(lefts, MiddleOf(rights));
        if (isLeftReversed)
        {
            Array.Reverse(lefts);
        }

        bool isRightReversed = !IsLeftOf(rights, MiddleOf(lefts));
        return isLeftReversed == left.IsReversed && isRightReversed == right.IsReversed;
    }

    private Vector3D[] PlacesOf(LaneBorder border, List<BorderNode>? nodes) =>
        nodes is null ? [.. border.Nodes.Select(node => _borders.Nodes[node])] : [.. nodes.Select(node => node.Place)];

    private static Vector3D MiddleOf(Vector3D[] places) => places.Length > 2 ? places[places.Length / 2] : (places[0] + places[^1]) * 0.5;

    /// <summary>
    /// Whether a place lies on the left of the nearest piece of a line. If a node is nearest whose two pieces do not agree, it lies on the
    /// outside of the bend.
    /// </summary>
    private static bool IsLeftOf(Vector3D[] line, Vector3D place)
    {
        (double best, int nearest, bool atEnd) = (double.PositiveInfinity, 0, false);
        for (int i = 1; i < line.Length; i++)
        {
            Vector3D piece = line[i] - line[i - 1];
            double square = piece.Dot(piece);
            double along = square > 0 ? Math.Clamp((place - line[i - 1]).Dot(piece) / square, 0, 1) : 0;
            double apart = (place - line[i - 1] - (piece * along)).Length;
            if (apart < best)
            {
                (best, nearest, atEnd) = (apart, i, along >= 1);
            }
        }

        bool isLeft = IsLeft(line[nearest - 1], line[nearest], place);
        return atEnd && nearest + 1 < line.Length && isLeft != IsLeft(line[nearest], line[nearest + 1], place)
            ? !IsLeft(line[nearest - 1], line[nearest], line[nearest + 1])
            : isLeft;
    }

    private static bool IsLeft(Vector3D from, Vector3D to, Vector3D place) =>
        ((to.X - from.X) * (place.Y - from.Y)) - ((to.Y - from.Y) * (place.X - from.X)) > 0;
}
