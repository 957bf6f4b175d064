using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Plans;

/// <summary>
/// Tells when the picture has settled after a change of place, weather or hour: two comparisons in a row, half a second apart, find the
/// same picture except for what moves in it.
/// </summary>
/// <param name="screen">The game's picture.</param>
/// <param name="clock">Real time.</param>
public sealed class PictureSettling(IScreen screen, IClock clock)
{
    /// <summary>Time between two pictures that are compared, milliseconds.</summary>
    public const double IntervalMilliseconds = 500;

    /// <summary>Greatest mean difference of the bytes of two pictures that count as the same; moving traffic makes about 1.</summary>
    private const double SameMeanDifference = 2;
    private const int SameInARow = 2;
    private static readonly Geometry.Cameras.ImageSize Size = new(160, 120);
    private PixelBuffer _last = new(Size);
    private PixelBuffer _next = new(Size);
    private bool _hasLast;
    private double _takenAt;
    private int _same;

    /// <summary>Discards the pictures, at the beginning of a wait.</summary>
    public void Begin() => (_hasLast, _same, _takenAt) = (false, 0, double.NegativeInfinity);

    /// <summary>Looks at the picture, if it is time.</summary>
    /// <returns>Whether it has settled.</returns>
    public bool Look()
    {
        if (clock.Milliseconds - _takenAt >= IntervalMilliseconds && screen.Grab(_next).IsGood)
        {
            _same = _hasLast && PictureDifference.MeanOf(_last, _next) <= SameMeanDifference ? _same + 1 : 0;
            (_last, _next, _hasLast, _takenAt) = (_next, _last, true, clock.Milliseconds);
        }

        return _same >= SameInARow;
    }
}
