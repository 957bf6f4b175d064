using System.Globalization;
using Harvester.Datasets.Logs;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Makes a scenario of what its frames gave: resamples it to steps of 0.1 s, and numbers tracks and features.</summary>
internal sealed class ScenarioAssembly
{
    /// <summary>Ids of tracks whose object has none in labels begin behind those of labels; the first is the ego's.</summary>
    private const int FirstOwnId = 1 << 16;

    private readonly List<MotionMoment> _moments = [];
    private readonly SortedDictionary<string, NamedFeature> _features = new(StringComparer.Ordinal);
    private readonly Dictionary<string, long> _numbers = new(StringComparer.Ordinal);

    private ScenarioAssembly(IEnumerable<byte[]> parts)
    {
        foreach (MotionMoment moment in parts.Select(MotionPart.Parse))
        {
            foreach (NamedFeature feature in moment.Features)
            {
                _features[feature.Name] = _features.TryGetValue(feature.Name, out NamedFeature? known) ? known.With(feature) : feature;
            }

            _moments.Add(moment with { Features = [] });
        }

        _moments.Sort((a, b) => a.Seconds.CompareTo(b.Seconds));
        foreach (string name in _features.Keys)
        {
            _numbers.Add(name, _numbers.Count + 1);
        }
    }

    /// <summary>Makes a scenario.</summary>
    /// <param name="name">Its name, of <see cref="ScenarioWindow.Name"/>.</param>
    /// <param name="parts">The files of <see cref="MotionPart"/> of its frames and those just before and after it.</param>
    public static AssembledScenario Of(string name, IEnumerable<byte[]> parts) => new ScenarioAssembly(parts).Assemble(name);

    private AssembledScenario Assemble(string name)
    {
        int window = int.Parse(name.AsSpan(name.IndexOf('_', StringComparison.Ordinal) + 1), CultureInfo.InvariantCulture);
        (MotionMoment Before, MotionMoment After, double Part)?[] steps =
        [
            .. Enumerable.Range(0, ScenarioWindow.Steps).Select(step => Around(ScenarioWindow.TimeOf(window, step))),
        ];
        int count = Array.FindLastIndex(steps, step => step is not null) + 1;
        if (count == 0)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant(
                    $"scenario {name}: its frames are more than {ScenarioWindow.MaxGap} s apart, too far to interpolate."
                )
            );
        }

        Array.Resize(ref steps, count);
        LogTrack[] tracks = [.. TracksOf(steps)];
        return new AssembledScenario(
            new MotionLog(
                name,
                [.. Enumerable.Range(0, count).Select(step => Math.Round(step * ScenarioWindow.Step, 1))],
                tracks,
                Array.FindIndex(tracks, track => track.Id == FirstOwnId),
                [.. _features.Values.Select(FeatureOf)],
                [.. steps.Select(SignalsAt)]
            ),
            [.. steps.Select(step => step is { Part: 0 })]
        );
    }

    /// <summary>The frames before and after a time, and where between them it is; null if there is none near it.</summary>
    private (MotionMoment Before, MotionMoment After, double Part)? Around(double seconds)
    {
        int after = _moments.FindIndex(moment => moment.Seconds >= seconds - ScenarioWindow.SameTime);
        if (after < 0)
        {
            return null;
        }

        if (_moments[after].Seconds <= seconds + ScenarioWindow.SameTime)
        {
            return (_moments[after], _moments[after], 0);
        }

        double gap = after == 0 ? double.PositiveInfinity : _moments[after].Seconds - _moments[after - 1].Seconds;
        return gap <= ScenarioWindow.MaxGap ? (_moments[after - 1], _moments[after], (seconds - _moments[after - 1].Seconds) / gap) : null;
    }

    private IEnumerable<LogTrack> TracksOf((MotionMoment Before, MotionMoment After, double Part)?[] steps)
    {
        var states = new Dictionary<string, LogState?[]>(StringComparer.Ordinal);
        for (int step = 0; step < steps.Length; step++)
        {
            if (steps[step] is not { } place)
            {
                continue;
            }

            Dictionary<string, LogState> after = place.After.Actors.ToDictionary(
                actor => actor.Key,
                actor => actor.State,
                StringComparer.Ordinal
            );
            foreach (MotionActor actor in place.Before.Actors)
            {
                if (after.TryGetValue(actor.Key, out LogState next))
                {
                    if (!states.TryGetValue(actor.Key, out LogState?[]? track))
                    {
                        states.Add(actor.Key, track = new LogState?[steps.Length]);
                    }

                    track[step] = LogState.Between(actor.State, next, place.Part);
                }
            }
        }

        ILookup<string, MotionActor> actors = _moments
            .SelectMany(moment => moment.Actors)
            .ToLookup(actor => actor.Key, StringComparer.Ordinal);
        var taken = new HashSet<int>();
        int nextOwn = FirstOwnId + 1;
        foreach (string key in states.Keys.Order(StringComparer.Ordinal))
        {
            int? known = actors[key].Select(actor => actor.Id).FirstOrDefault(id => id is not null);
            int id =
                key == MotionActors.Ego ? FirstOwnId
                : known is { } given && taken.Add(given) ? given
                : nextOwn++;
            yield return new LogTrack(id, actors[key].First().Kind, states[key]);
        }
    }

    private LogFeature FeatureOf(NamedFeature feature)
    {
        long[] Numbered(IReadOnlyList<string> names) => [.. names.Where(_numbers.ContainsKey).Select(name => _numbers[name])];
        return new LogFeature(_numbers[feature.Name], feature.Kind, feature.Type, feature.Points)
        {
            IsWay = feature.IsWay,
            Entries = Numbered(feature.Entries),
            Exits = Numbered(feature.Exits),
            LeftNeighbours = Numbered(feature.Left),
            RightNeighbours = Numbered(feature.Right),
            LeftBoundaries = Numbered(feature.LeftLines),
            RightBoundaries = Numbered(feature.RightLines),
            Lanes = Numbered(feature.Lanes),
        };
    }

    /// <summary>The lights of a step; between two frames that do not agree, a light is unknown.</summary>
    private IReadOnlyList<LogSignal> SignalsAt((MotionMoment Before, MotionMoment After, double Part)? step) =>
        step is not { } place
            ? []
            :
            [
                .. place
                    .Before.Lights.Where(light => place.After.Lights.ContainsKey(light.Key) && _features.ContainsKey(light.Key))
                    .OrderBy(light => light.Key, StringComparer.Ordinal)
                    .Select(light => new LogSignal(
                        _numbers[light.Key],
                        place.After.Lights[light.Key] == light.Value ? light.Value : LogLight.Unknown,
                        _features[light.Key].Points[^1]
                    )),
            ];
}
