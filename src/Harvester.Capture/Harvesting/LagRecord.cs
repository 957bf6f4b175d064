using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>States and changes of the picture, tick by tick, of a game that came to stand.</summary>
internal sealed class LagRecord(SceneComparison comparison)
{
    /// <summary>The last pictures of a record, which show what changes from picture to picture in a standing game: rain, grain, flicker.</summary>
    public const int NoiseTicks = 3;

    /// <summary>By what factor a change must stand out from the noise to count as movement.</summary>
    public const double MovementOverNoise = 3;

    private readonly List<SceneSnapshot> _states = [];
    private readonly List<double> _changes = [];

    /// <summary>Adds a tick.</summary>
    /// <param name="state">What was read.</param>
    /// <param name="change">How much the picture differs from the tick's before; not a number when there was no good picture.</param>
    public void Add(SceneSnapshot state, double change)
    {
        _states.Add(state);
        _changes.Add(change);
    }

    /// <summary>The lag that the record shows; null when ticks or pictures are missing, or camera or entities did not move, or no movement was seen.</summary>
    public PictureLag? Lag
    {
        get
        {
            int last = _states.Count - 1;
            if (last <= NoiseTicks || _changes.Any(double.IsNaN) || _states[last].GameFrame - _states[0].GameFrame != last)
            {
                return null;
            }

            int camera = FirstStill(state => comparison.CameraStands(state, _states[last]));
            int entities = FirstStill(state => comparison.FirstDifference(state.Entities, _states[last].Entities) is null);
            double noise = _changes.Skip(_changes.Count - NoiseTicks).Max();

            // The first change is against no picture at all.
            int change = last;
            while (change > 0 && _changes[change] <= MovementOverNoise * noise)
            {
                change--;
            }

            var lag = new PictureLag(change - camera, change - entities);
            bool moved = camera > 0 && entities > 0 && change > 0;
            return moved && lag is { CameraTicks: >= -1, EntityTicks: >= 0 } ? lag : null;
        }
    }

    private int FirstStill(Func<SceneSnapshot, bool> isLikeLast)
    {
        int first = _states.Count - 1;
        while (first > 0 && isLikeLast(_states[first - 1]))
        {
            first--;
        }

        return first;
    }
}
