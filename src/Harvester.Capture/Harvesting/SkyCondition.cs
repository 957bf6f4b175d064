using System.Globalization;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>A sky under which a moment is photographed.</summary>
/// <param name="Name">Its name in file names.</param>
/// <param name="SetWeather">The weather to set; null for that of the moment.</param>
/// <param name="SetTimeOfDay">The time of day to set; null for that of the moment.</param>
/// <param name="Moment">The sky of the moment.</param>
internal sealed record SkyCondition(string Name, string? SetWeather, TimeSpan? SetTimeOfDay, EnvironmentState Moment)
{
    /// <summary>Its number: 0 for the sky of the moment, then from 1.</summary>
    public int Number { get; init; }

    /// <summary>The weather.</summary>
    public string Weather => SetWeather ?? Moment.Weather;

    /// <summary>The time of day.</summary>
    public TimeSpan TimeOfDay => SetTimeOfDay ?? Moment.TimeOfDay;

    /// <summary>The sky of the frame's image.</summary>
    public static SkyCondition OfMoment(EnvironmentState moment) => new("base", null, null, moment);

    /// <summary>All skies that options ask for, hour by hour: what depends on the sun, such as shadows, stays the same meanwhile.</summary>
    public static IEnumerable<SkyCondition> AllOf(PairOptions options, EnvironmentState moment) =>
        (
            options.Conditions == 0
                ? []
                : from hour in options.Hours.Count == 0 ? [null] : options.Hours.Select(hour => (int?)hour)
                from weather in options.Weathers.Count == 0 ? [null] : options.Weathers.Select(weather => (string?)weather)
                select new SkyCondition(
                    (weather ?? "same") + (hour is { } at ? at.ToString("-00", CultureInfo.InvariantCulture) : ""),
                    weather,
                    hour is { } set ? TimeSpan.FromHours(set) : null,
                    moment
                )
        ).Select((condition, number) => condition with { Number = number + 1 });
}
