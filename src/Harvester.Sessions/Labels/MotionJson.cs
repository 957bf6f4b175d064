using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>
/// Writes the motion between frames: a row of numbers for each tick. A row ends where the rest is unknown, after the velocity or after the
/// acceleration.
/// </summary>
internal static class MotionJson
{
    /// <summary>Writes the rows with their key; nothing if motion is not recorded.</summary>
    public static void Append(JsonText json, IReadOnlyList<MotionSample>? samples)
    {
        if (samples is null)
        {
            return;
        }

        json.Key("motion").BeginArray();
        foreach (MotionSample sample in samples)
        {
            json.BeginArray().Number(sample.TimeSeconds, LabelDecimals.Seconds);
            Append(json, sample.Position, LabelDecimals.Metres);
            Append(json, sample.Right, LabelDecimals.Axis);
            Append(json, sample.Forward, LabelDecimals.Axis);
            Append(json, sample.Velocity, LabelDecimals.Speed);
            if (sample.Motion is { } motion)
            {
                json.Number(motion.YawRate, EgoMotionJson.RateDecimals).Number(motion.Acceleration, LabelDecimals.Speed);
                if (motion is { Steering: { } steering, Throttle: { } throttle, Brake: { } brake })
                {
                    json.Number(steering, EgoMotionJson.ControlDecimals)
                        .Number(throttle, EgoMotionJson.ControlDecimals)
                        .Number(brake, EgoMotionJson.ControlDecimals);
                }
            }

            json.EndArray();
        }

        json.EndArray();
    }

    private static void Append(JsonText json, Vector3D value, int decimals) =>
        json.Number(value.X, decimals).Number(value.Y, decimals).Number(value.Z, decimals);
}
