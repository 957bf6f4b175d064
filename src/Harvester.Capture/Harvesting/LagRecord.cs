using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// States and changes of the picture, tick by tick, of a game that came to stand. The lag is the shift by which the changes fit the
/// movement best (<see cref="LagAlignment"/>), of camera and entities together: a world that creeps on after the freeze, seen or not, moves
/// both alike, while the last change alone would tell the end of the creep from a lag by the smallest movement that can be seen.
/// </summary>
internal sealed class LagRecord
{
    /// <summary>
    /// The last pictures of a record, which show what changes from picture to picture in a standing game: rain, grain, flicker.
    /// </summary>
    public const int NoiseTicks = 3;

    /// <summary>By what factor a change must stand out from the noise to count as movement.</summary>
    public const double MovementOverNoise = 3;

    // The greatest share of the differences between the changes that the movement may leave unexplained; noise is a third at most.
    private const double MaxUnexplained = 0.25;

    // By how much of the differences the best lag must be better than any other: less is decided by noise.
    private const double MinMargin = 0.01;

    private readonly List<SceneSnapshot> _states = [];
    private readonly List<double> _changes = [];

    /// <summary>Adds a tick before the first picture; as many as the greatest lag are needed, and one more.</summary>
    public void Add(SceneSnapshot state) => _states.Add(state);

    /// <summary>Adds a tick with a picture.</summary>
    /// <param name="state">The scene read in this tick.</param>
    /// <param name="change">
    /// How much the picture differs from the tick's before; the first is of no meaning; not a number when there was no good picture.
    /// </param>
    public void Add(SceneSnapshot state, double change)
    {
        _states.Add(state);
        _changes.Add(change);
    }

    /// <summary>
    /// The lag that the record shows; null when ticks or pictures are missing, camera or entities did not move, or the pictures do not show
    /// which lag it is.
    /// </summary>
    /// <param name="runningTicks">The pictures before the freeze, without the first, 1 or more.</param>
    /// <param name="greatestTicks">The greatest lag to look for, 0 or more.</param>
    public PictureLag? LagOf(int runningTicks, int greatestTicks)
    {
        int last = _states.Count - 1;
        int firstChange = _states.Count - _changes.Count + 1;
        if (_changes.Count <= runningTicks + NoiseTicks || firstChange <= greatestTicks || _changes.Any(double.IsNaN)
            || _states[last].GameFrame - _states[0].GameFrame != last)
        {
            return null;
        }

        double[] changes = [.. _changes.Skip(1)];
        double noise = changes.Skip(changes.Length - NoiseTicks).Max();
        double running = Median(changes.Take(runningTicks));
        double[] camera = Motions(SceneMotion.OfCamera);
        double[] entities = Motions(SceneMotion.OfEntities);
        double fullCamera = Median(camera.Skip(1).Take(firstChange));
        double fullEntities = Median(entities.Skip(1).Take(firstChange));
        if (!(running > MovementOverNoise * noise && fullCamera > 0 && fullEntities > 0))
        {
            return null;
        }

        // What changes more than usual, as at the cut of a flickering lamp, says no more than that all moves.
        changes = [.. changes.Select(change => Math.Min(1, change / running))];
        return Best(
            new LagAlignment(camera, fullCamera, changes, firstChange), new LagAlignment(entities, fullEntities, changes, firstChange),
                greatestTicks, Spread(changes));
    }

    private static PictureLag? Best(LagAlignment camera, LagAlignment entities, int greatestTicks, double spread)
    {
        var costs = new List<(PictureLag Lag, double Cost)>();
        for (int ticks = 0; ticks <= greatestTicks; ticks++)
        {
            // The camera is reported with the entities or a tick late.
            foreach (int cameraTicks in new[] { ticks, ticks - 1 })
            {
                costs.Add((new PictureLag(cameraTicks, ticks), (camera.CostOf(cameraTicks) + entities.CostOf(ticks)) / 2));
            }
        }

        (PictureLag lag, double cost) = costs.OrderBy(entry => entry.Cost).First();
        double next = costs.Where(entry => entry.Lag != lag).Min(entry => entry.Cost);
        return cost <= MaxUnexplained * spread && next - cost >= MinMargin * spread ? lag : null;
    }

    private double[] Motions(Func<SceneSnapshot, SceneSnapshot, double> motion) =>
        [0, .. _states.Skip(1).Select((state, i) => motion(_states[i], state))];

    private static double Spread(double[] values)
    {
        double mean = values.Average();
        return values.Sum(value => (value - mean) * (value - mean));
    }

    private static double Median(IEnumerable<double> values)
    {
        double[] sorted = [.. values.OrderBy(value => value)];
        return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
    }
}
