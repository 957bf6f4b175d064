using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Decides from successive pictures of a frozen game when a change that was asked for, such as a new sky, is complete. Means of blocks are
/// compared, in which noise averages out. The picture has settled when it differs from all of some ticks before by hardly more than noise
/// does, which is what is left of three successive pictures when an even change is taken off. A picture that is still as before the change
/// may not show it yet, so it counts as settled only after a longer time.
/// </summary>
internal sealed class SettledPicture
{
    /// <summary>Pictures are compared over this many ticks.</summary>
    public const int StillTicks = 8;

    /// <summary>A change that has not begun after this many ticks does not show.</summary>
    public const int OnsetTicks = 24;

    /// <summary>Within <see cref="StillTicks"/>, a still picture without noise changes by less, grey levels of 255.</summary>
    public const double ToleranceLevels = 0.1;

    /// <summary>A picture that differs by more from the one before the change shows it, grey levels of 255.</summary>
    public const double ChangeLevels = 0.5;

    /// <summary>Differences of noise vary; so much larger ones are still noise.</summary>
    private const double NoiseFactor = 2;

    private readonly List<BlockMeans> _pictures = [];
    private readonly int _extraTicks;
    private BlockMeans? _before;
    private int _ticks;

    /// <summary>Creates a detector.</summary>
    /// <param name="maxLagTicks">Maximum number of ticks by which a picture lags behind the game.</param>
    public SettledPicture(int maxLagTicks) => _extraTicks = maxLagTicks;

    /// <summary>Begins to watch a change. The latest picture, if there is any, is the one before it.</summary>
    public void Begin()
    {
        _before = _pictures.LastOrDefault();
        _ticks = 0;
        _pictures.Clear();
    }

    /// <summary>Takes the picture of a tick after the change was asked for.</summary>
    /// <returns>Whether the picture has settled.</returns>
    public bool Observe(PixelBuffer picture)
    {
        var now = BlockMeans.Of(picture);
        _ticks++;
        _pictures.Add(now);
        if (_pictures.Count <= StillTicks)
        {
            return false;
        }

        BlockDifference[] noise =
        [
            .. Enumerable.Range(2, StillTicks - 1).Select(i => BlockMeans.NoiseOf(_pictures[i - 2], _pictures[i - 1], _pictures[i])),
        ];
        double greatestNoise = NoiseFactor * MedianOf(noise.Select(each => each.Greatest));
        double meanNoise = NoiseFactor * MedianOf(noise.Select(each => each.Mean));
        bool isStill = _pictures
            .Take(StillTicks)
            .Select(now.DifferenceTo)
            .All(difference => difference.Greatest <= ToleranceLevels + greatestNoise && difference.Mean <= ToleranceLevels + meanNoise);
        _pictures.RemoveAt(0);
        return isStill
            && (
                _ticks >= OnsetTicks + _extraTicks
                || (_before is not null && now.DifferenceTo(_before).Greatest > ChangeLevels + greatestNoise)
            );
    }

    private static double MedianOf(IEnumerable<double> values)
    {
        double[] sorted = [.. values.OrderBy(static value => value)];
        return sorted[sorted.Length / 2];
    }
}
