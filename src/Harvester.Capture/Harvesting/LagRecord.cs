using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// States and changes of the picture, tick by tick, of a game that is being frozen. The lag is the shift by which the changes best fit the
/// movement (<see cref="LagAlignment"/>), of camera and entities together: a world that creeps on after the freeze moves both alike, while
/// the last change alone could not distinguish the end of the creep from a lag.
/// </summary>
internal sealed class LagRecord
{
    /// <summary>The last images of a record, which show what changes from image to image in a still game: rain, grain, flicker.</summary>
    public const int NoiseTicks = 3;

    /// <summary>Factor by which a change must exceed the noise to count as movement.</summary>
    public const double MovementOverNoise = 3;

    // Maximum fraction of the differences between the changes that the movement may leave unexplained; noise is a third at most.
    private const double MaxUnexplained = 0.25;

    // Fraction of the differences by which the best lag must be better than any other: less could be noise.
    private const double MinMargin = 0.01;

    private readonly List<SceneSnapshot> _states = [];
    private readonly List<double> _changes = [];

    /// <summary>Adds a tick before the first image; the record needs one more than the greatest lag.</summary>
    public void Add(SceneSnapshot state) => _states.Add(state);

    /// <summary>Adds a tick with an image.</summary>
    /// <param name="state">The scene read in this tick.</param>
    /// <param name="change">
    /// How much the image differs from that of the previous tick; ignored for the first; NaN if there was no usable image.
    /// </param>
    public void Add(SceneSnapshot state, double change)
    {
        _states.Add(state);
        _changes.Add(change);
    }

    /// <summary>
    /// The lag that the record shows; null if ticks or images are missing, camera or entities did not move, or the images do not determine
    /// the lag.
    /// </summary>
    /// <param name="runningTicks">Number of images before the freeze, without the first; 1 or more.</param>
    /// <param name="maxTicks">Maximum lag to look for; 0 or more.</param>
    public PictureLag? LagOf(int runningTicks, int maxTicks)
    {
        int last = _states.Count - 1;
        int firstChange = _states.Count - _changes.Count + 1;
        if (
            _changes.Count <= runningTicks + NoiseTicks
            || firstChange <= maxTicks
            || _changes.Any(double.IsNaN)
            || _states[last].GameFrame - _states[0].GameFrame != last
        )
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

        // A change larger than usual, as when a flickering lamp switches, only shows that everything moves.
        changes = [.. changes.Select(change => Math.Min(1, change / running))];
        return Best(
            new LagAlignment(camera, fullCamera, changes, firstChange),
            new LagAlignment(entities, fullEntities, changes, firstChange),
            maxTicks,
            Spread(changes)
        );
    }

    private static PictureLag? Best(LagAlignment camera, LagAlignment entities, int maxTicks, double spread)
    {
        var costs = new List<(PictureLag Lag, double Cost)>();
        for (int ticks = 0; ticks <= maxTicks; ticks++)
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
