using System;
using System.Collections.Generic;
using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Harvesting;

/// <summary>What the command line asks of a harvest.</summary>
internal sealed record HarvestPlan
{
    /// <summary>Where the session goes.</summary>
    public required string Folder { get; init; }

    /// <summary>Whether a session that lies there is replaced.</summary>
    public required bool Overwrite { get; init; }

    /// <summary>How frames are taken and labelled. The table of faces is added when the game is built.</summary>
    public required HarvestOptions Options { get; init; }

    /// <summary>Frames to take, those of other shards included.</summary>
    public required int Frames { get; init; }

    /// <summary>Random seed of the world.</summary>
    public required int Seed { get; init; }

    /// <summary>Vertical field of view, degrees.</summary>
    public required double FovDegrees { get; init; }

    /// <summary>File of the roads to drive on; null for a town made from the seed.</summary>
    public required string? Roads { get; init; }

    /// <summary>Files of the lights and lamps that stand by the roads; none to make them up.</summary>
    public required IReadOnlyList<string> Props { get; init; }

    /// <summary>File of spaces of interest that goes before the simulated game's own; null for none.</summary>
    public required string? Faces { get; init; }

    /// <summary>Where to start, metres, world; null for the middle of the roads.</summary>
    public required Vector2D? Near { get; init; }

    /// <summary>The game's name of the weather.</summary>
    public required string Weather { get; init; }

    /// <summary>The hour at the beginning.</summary>
    public required TimeSpan TimeOfDay { get; init; }

    /// <summary>Where the lane indicators are measured.</summary>
    public required LookAhead LookAhead { get; init; }

    /// <summary>Width of the lanes of an ordinary road, metres.</summary>
    public required double LaneWidth { get; init; }

    /// <summary>Width of the lanes of a narrow road, metres.</summary>
    public required double NarrowLaneWidth { get; init; }

    /// <summary>In what the game misbehaves.</summary>
    public required GameQuirks Quirks { get; init; }

    /// <summary>The same as the option says it; null for nothing.</summary>
    public required string? QuirksAsked { get; init; }
}
