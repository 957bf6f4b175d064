namespace Harvester.Geometry.Roads;

/// <summary>
/// The centre lines of a network as smooth curves. Within a chain of links that continue each other, the direction at a node is common to
/// both links, weighted so that nodes on a circle give the circle's tangent whatever their spacing. At the end of a chain, the direction
/// makes the last link a circular arc.
/// </summary>
public sealed class RoadCurves
{
    private readonly RoadCurve[] _curves;

    /// <summary>Creates the curves of all links.</summary>
    public RoadCurves(RoadNetwork network)
    {
        Network = Guard.NotNull(network, nameof(network));
        Continuations = new RoadContinuations(network);
        _curves = new RoadCurve[network.Links.Count];
        for (int i = 0; i < _curves.Length; i++)
        {
            _curves[i] = Curve(i);
        }
    }

    /// <summary>The network whose links the curves follow.</summary>
    public RoadNetwork Network { get; }

    /// <summary>The links that continue each other.</summary>
    public RoadContinuations Continuations { get; }

    /// <summary>The centre line of a link.</summary>
    /// <param name="link">Index of the link.</param>
    public RoadCurve Of(int link) => _curves[link];

    private RoadCurve Curve(int link)
    {
        RoadLink road = Network.Links[link];
        Vector3D start = Network.Nodes[road.From].Position;
        Vector3D end = Network.Nodes[road.To].Position;
        Vector2D chord = Ground(end - start);
        Vector2D along = Unit(chord);
        Vector2D? atStart = Common(chord, Continuations.Of(link, beyondEnd: false), road.From, before: true);
        Vector2D? atEnd = Common(chord, Continuations.Of(link, beyondEnd: true), road.To, before: false);
        return new RoadCurve(
            start,
            end,
            atStart ?? (atEnd is { } e ? Mirrored(e, along) : along),
            atEnd ?? (atStart is { } s ? Mirrored(s, along) : along)
        );
    }

    /// <summary>The direction that a link and its continuation have at the node between them; null without a continuation.</summary>
    private Vector2D? Common(Vector2D chord, int neighbour, int node, bool before)
    {
        if (neighbour == RoadContinuations.None)
        {
            return null;
        }

        RoadLink other = Network.Links[neighbour];
        int far = other.From == node ? other.To : other.From;
        Vector2D otherChord = Ground(Network.Nodes[far].Position - Network.Nodes[node].Position);
        otherChord = before ? otherChord * -1 : otherChord;

        // On a circle the tangent makes half of each chord's arc α with it, and chords are as long as sin(α / 2). The sum of unit chords,
        // each times the other's length, has exactly this direction.
        Vector2D sum = (Unit(chord) * otherChord.Length) + (Unit(otherChord) * chord.Length);
        return sum.Length > 0 ? Unit(sum) : null;
    }

    // A circular arc makes the same angle with its chord at both ends, on opposite sides: d' = 2 (d · axis) axis - d.
    private static Vector2D Mirrored(Vector2D direction, Vector2D axis) => (axis * (2 * direction.Dot(axis))) - direction;

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);

    private static Vector2D Unit(Vector2D vector) => vector.Length > 0 ? vector * (1 / vector.Length) : new Vector2D(0, 1);
}
