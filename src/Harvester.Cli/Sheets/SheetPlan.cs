using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Sheets;

/// <summary>A contact sheet as the command line describes it.</summary>
internal sealed record SheetPlan
{
    /// <summary>The road network; null for a town generated from the seed.</summary>
    public required RoadNetwork? Roads { get; init; }

    /// <summary>Traffic lights and street lamps; null to generate them.</summary>
    public required IReadOnlyList<PropPlacement>? Props { get; init; }

    /// <summary>Random seed of the worlds.</summary>
    public required int Seed { get; init; }

    /// <summary>The places, at least one.</summary>
    public required IReadOnlyList<SheetPlace> Places { get; init; }

    /// <summary>Names of weathers, at least one.</summary>
    public required IReadOnlyList<string> Weathers { get; init; }

    /// <summary>Times of day, at least one.</summary>
    public required IReadOnlyList<TimeSpan> Times { get; init; }

    /// <summary>How long the ego has driven, seconds, ascending; at least one.</summary>
    public required IReadOnlyList<double> Seconds { get; init; }

    /// <summary>Size of a tile's picture, pixels.</summary>
    public required ImageSize Tile { get; init; }

    /// <summary>Vertical field of view, degrees.</summary>
    public required double FovDegrees { get; init; }

    /// <summary>The moments of each place, in the order of the tiles.</summary>
    public IEnumerable<SheetMoment> Moments =>
        from weather in Weathers from time in Times from seconds in Seconds select new SheetMoment(weather, time, seconds);
}
