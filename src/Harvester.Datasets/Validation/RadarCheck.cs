using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the detections of radars: they lie before the sensor, by ascending range, and clutter is no object.</summary>
internal static class RadarCheck
{
    private const double QuarterTurn = 90;

    public static IEnumerable<string> Problems(FrameLabel label)
    {
        foreach (RadarScan scan in label.Channels.Get<RadarsLabel>()?.Scans ?? [])
        {
            double before = 0;
            foreach ((RadarDetection detection, int index) in scan.Detections.Select((detection, index) => (detection, index)))
            {
                string name = FormattableString.Invariant($"detection {index} of radar '{scan.Sensor}'");
                if (!(detection.Range > 0) || detection.Range < before)
                {
                    yield return $"{name} is not beyond the sensor and the detection before it.";
                }

                if (Math.Abs(detection.ElevationDegrees) > QuarterTurn || Math.Abs(detection.AzimuthDegrees) > 2 * QuarterTurn)
                {
                    yield return $"{name} has an angle outside its range.";
                }

                if (detection is { Origin: RadarOrigin.Clutter, Object: not 0 } or { Origin: RadarOrigin.Ghost, Object: 0 })
                {
                    yield return $"{name} is {(detection.Object == 0 ? "a ghost of no object" : "clutter and has an object")}.";
                }

                before = detection.Range;
            }
        }
    }
}
