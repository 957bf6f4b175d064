using System;
using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Harvesting;

/// <summary>What the command line asks of a harvest.</summary>
internal sealed record HarvestPlan
{
    /// <summary>Where the session goes.</summary>
    public required string Folder { get; init; }

    /// <summary>Whether a session that lies there is replaced.</summary>
    public required bool Overwrite { get; init; }

    /// <summary>Frames to take.</summary>
    public required int Frames { get; init; }

    /// <summary>Decides everything that is left to chance.</summary>
    public required int Seed { get; init; }

    /// <summary>Size of the images, pixels.</summary>
    public required ImageSize Image { get; init; }

    /// <summary>Format of the images.</summary>
    public required ImageFormat Format { get; init; }

    /// <summary>Quality of JPEG images, 1 to 100.</summary>
    public required int JpegQuality { get; init; }

    /// <summary>Vertical field of view, degrees.</summary>
    public required double FovDegrees { get; init; }

    /// <summary>What separates the game's picture from a pinhole's; the labels know it.</summary>
    public required Lens Lens { get; init; }

    /// <summary>
    /// The largest error of the camera model over markers with which a harvest starts, pixels; null to leave the check out.
    /// </summary>
    public required double? MaxCameraErrorPixels { get; init; }

    /// <summary>Frames per second of the game's time.</summary>
    public required double RateHz { get; init; }

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

    /// <summary>Whether instance masks are made.</summary>
    public required bool Masks { get; init; }

    /// <summary>Rays that a frame may take at most.</summary>
    public required int RayBudget { get; init; }

    /// <summary>Beyond this rays are not trusted to meet objects, metres.</summary>
    public required double RayReachMetres { get; init; }

    /// <summary>Whether the scenes are written, so that the session can be relabelled.</summary>
    public required bool Scenes { get; init; }

    /// <summary>Which of the frames are taken.</summary>
    public required Shard Shard { get; init; }

    /// <summary>How far objects are labelled, metres.</summary>
    public required double RangeMetres { get; init; }

    /// <summary>How far objects beyond the labelling range are marked by ignore regions, metres.</summary>
    public required double IgnoreRangeMetres { get; init; }

    /// <summary>Where the lane indicators are measured.</summary>
    public required LookAhead LookAhead { get; init; }

    /// <summary>Width of the lanes of an ordinary road, metres.</summary>
    public required double LaneWidth { get; init; }

    /// <summary>Width of the lanes of a narrow road, metres.</summary>
    public required double NarrowLaneWidth { get; init; }

    /// <summary>The classes to label; null for all.</summary>
    public required IReadOnlyList<ObjectClass>? Classes { get; init; }

    /// <summary>How many ticks the game's picture may be late.</summary>
    public required int MaxPictureLagTicks { get; init; }

    /// <summary>How the game is frozen for each frame; null to try every way at the start.</summary>
    public required FreezeMethod? FreezeBy { get; init; }

    /// <summary>In what the game misbehaves.</summary>
    public required GameQuirks Quirks { get; init; }

    /// <summary>The same as the option says it; null for nothing.</summary>
    public required string? QuirksAsked { get; init; }
}
