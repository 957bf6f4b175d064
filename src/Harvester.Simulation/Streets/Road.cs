using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Streets;

/// <summary>A chain of links with one lane layout, from one end node to the next, with the smooth line through their nodes.</summary>
internal sealed class Road(int index, IReadOnlyList<int> nodes, LaneLayout layout, RoadNodeFlags flags, StreetCurve curve)
{
    /// <summary>The greatest <see cref="Shoulder"/>, metres.</summary>
    public const double WidestShoulder = 2.5;

    /// <summary>A car with room before and behind it, metres.</summary>
    private const double ShortestToWait = 7;

    public int Index { get; } = index;

    /// <summary>Numbers of the network's nodes along it.</summary>
    public IReadOnlyList<int> Nodes { get; } = nodes;

    public LaneLayout Layout { get; } = layout;

    /// <summary>The flags common to all its nodes except the shared ones at its ends.</summary>
    public RoadNodeFlags Flags { get; } = flags;

    public StreetCurve Curve { get; } = curve;

    /// <summary>How densely the land around it is built up.</summary>
    public Zone Zone { get; init; } = Zone.Town;

    /// <summary>Metres at the start that belong to the junction there.</summary>
    public double StartTrim { get; set; }

    /// <summary>Metres at the end that belong to the junction there.</summary>
    public double EndTrim { get; set; }

    /// <summary>Whether other roads overlap it at its start: more than two meet, or it turns a corner.</summary>
    public bool StartsAtCrossing { get; set; }

    /// <summary>The same at its end.</summary>
    public bool EndsAtCrossing { get; set; }

    /// <summary>Whether it is a stub within a junction of several nodes, without markings or pavements.</summary>
    public bool IsInner { get; set; }

    /// <summary>Whether no car can wait between the junctions at its ends without standing in one of them.</summary>
    public bool IsTooShortToWait => IsInner || Length - StartTrim - EndTrim < ShortestToWait;

    public double Length => Curve.Length;

    public bool IsHighway => Flags.HasFlag(RoadNodeFlags.Highway);

    public bool IsUnpaved => Flags.HasFlag(RoadNodeFlags.OffRoad);

    /// <summary>Whether it is covered; only some road files know that.</summary>
    public bool IsInTunnel => Flags.HasFlag(RoadNodeFlags.Tunnel);

    /// <summary>Whether it has pavements and houses.</summary>
    public bool IsStreet => !IsHighway && !IsUnpaved && !IsInner && !IsAlley && Zone != Zone.Country && !IsInTunnel;

    /// <summary>Whether it is the lane of a car park or a yard: without traffic of its own and unknown to navigation.</summary>
    public bool IsAlley => Flags.HasFlag(RoadNodeFlags.SwitchedOff | RoadNodeFlags.NoGps);

    /// <summary>
    /// Width of asphalt beyond the carriageway's edges: a parking strip along a street, a hard shoulder along a motorway.
    /// </summary>
    public double Shoulder =>
        IsHighway ? WidestShoulder
        : IsStreet ? 2.4
        : IsInner ? 1.5
        : Zone == Zone.Country && !IsUnpaved ? 0.8
        : 0.4;

    /// <summary>Offset of the left border of the asphalt.</summary>
    public double LeftKerb => Layout.LeftEdge - Shoulder;

    /// <summary>Offset of the right border of the asphalt.</summary>
    public double RightKerb => Layout.RightEdge + Shoulder;

    public bool IsInTrim(double distance) => distance < StartTrim || distance > Length - EndTrim;

    /// <summary>Distance along the road from the nearest crossing at its ends, metres; infinite without one.</summary>
    public double CrossingDepthAt(double distance) =>
        Math.Min(StartsAtCrossing ? distance : double.PositiveInfinity, EndsAtCrossing ? Length - distance : double.PositiveInfinity);

    public double TrimAt(bool start) => start ? StartTrim : EndTrim;

    public void SetTrim(bool start, double value)
    {
        double clamped = Math.Min(value, 0.45 * Length);
        if (start)
        {
            StartTrim = clamped;
        }
        else
        {
            EndTrim = clamped;
        }
    }
}
