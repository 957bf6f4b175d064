using System.Globalization;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Runs.Sheets;

/// <summary>A contact sheet as the command line describes it.</summary>
public sealed record SheetPlan
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
        from weather in Weathers
        from time in Times
        from seconds in Seconds
        select new SheetMoment(weather, time, seconds);

    /// <summary>How much of the light the pictures show.</summary>
    public required Detail Detail { get; init; }

    /// <summary>The captions of all tiles, in their order.</summary>
    public IEnumerable<string> Captions => from place in Places from moment in Moments select CaptionOf(place, moment);

    /// <summary>The caption of a tile: place, weather, time of day and how long the ego has driven.</summary>
    public static string CaptionOf(SheetPlace place, SheetMoment moment)
    {
        string at = place.Position is { } position ? string.Create(CultureInfo.InvariantCulture, $"{position.X:0.#},{position.Y:0.#}") : "";
        string when = string.Create(CultureInfo.InvariantCulture, $"{moment.Weather} {moment.TimeOfDay:hh\\:mm} {moment.Seconds:0.##} s");
        return string.Join("  ", new[] { place.Name, at, when }.Where(part => part.Length > 0));
    }
}
