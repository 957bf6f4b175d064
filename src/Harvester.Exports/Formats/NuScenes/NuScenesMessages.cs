using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The messages of the ego at one tick. Vectors are in the ego frame: forward, left, up.</summary>
internal static class NuScenesMessages
{
    /// <summary>Turn of the steering wheel at full lock, radians: half of the range in nuScenes, -7.7 to 6.3.</summary>
    private const double FullLock = 7;

    /// <summary>Gravity, m/s², which the accelerometer feels.</summary>
    private const double Gravity = 9.81;

    /// <summary>Radius of a wheel, metres.</summary>
    private const double WheelRadius = 0.3;

    private const double MaxBrakeBar = 126;
    private const double MaxThrottle = 1000;
    private const double DegreesPerRadian = 180 / Math.PI;
    private const double KilometresPerHour = 3.6;
    private const int PedalFree = 1;
    private const int PedalPressed = 2;
    private const int Driving = 7;

    public static NuScenesMessage Pose(NuScenesMoment moment) =>
        Of(
            moment,
            ("accel", Vector(moment.Reading.Acceleration)),
            ("orientation", Quaternion(moment)),
            ("pos", Vector(moment.Position)),
            ("rotation_rate", Vector(moment.Reading.RotationRate)),
            ("vel", Vector(moment.Reading.Velocity))
        );

    public static NuScenesMessage Imu(NuScenesMoment moment)
    {
        Vector3D up = EgoTrack.InBody(moment.Reading.Pose.Axes, new Vector3D(0, 0, Gravity));
        return Of(
            moment,
            ("linear_accel", Vector(moment.Reading.Acceleration + up)),
            ("q", Quaternion(moment)),
            ("rotation_rate", Vector(moment.Reading.RotationRate))
        );
    }

    public static NuScenesMessage SteeringFeedback(NuScenesMoment moment) =>
        Of(moment, ("value", [moment.Reading.Controls!.Steering * FullLock]));

    public static NuScenesMessage Sensors(NuScenesMoment moment) =>
        Of(
            moment,
            ("brake_sensor", [BrakeSensor(moment.Reading.Controls!)]),
            ("steering_sensor", [SteeringDegrees(moment)]),
            ("throttle_sensor", [Throttle(moment)])
        );

    public static NuScenesMessage VehicleMonitor(NuScenesMoment moment)
    {
        EgoMotion? controls = moment.Reading.Controls;
        double rpm = WheelRpm(moment);
        return Of(
            moment,
            ("available_distance", [null]),
            ("battery_level", [null]),
            ("brake", [controls is null ? null : Math.Round(controls.Brake!.Value * MaxBrakeBar)]),
            (
                "brake_switch",
                [
                    controls is null ? null
                    : controls.Brake > 0 ? PedalPressed
                    : PedalFree,
                ]
            ),
            ("gear_position", [Driving]),
            ("left_signal", [null]),
            ("rear_left_rpm", [rpm]),
            ("rear_right_rpm", [rpm]),
            ("right_signal", [null]),
            ("steering", [SteeringDegrees(moment)]),
            ("steering_speed", [null]),
            ("throttle", [Throttle(moment)]),
            ("vehicle_speed", [moment.Reading.Velocity.Length * KilometresPerHour]),
            ("yaw_rate", [moment.Reading.RotationRate.Z * DegreesPerRadian])
        );
    }

    public static NuScenesMessage VehicleInfo(NuScenesMoment moment)
    {
        double rpm = WheelRpm(moment);
        double? steering = SteeringDegrees(moment);
        return Of(
            moment,
            ("FL_wheel_speed", [rpm]),
            ("FR_wheel_speed", [rpm]),
            ("RL_wheel_speed", [rpm]),
            ("RR_wheel_speed", [rpm]),
            ("left_solar", [null]),
            ("longitudinal_accel", [moment.Reading.Acceleration.X]),
            ("meanEffTorque", [null]),
            ("odom", [null]),
            ("odom_speed", [moment.Reading.Velocity.Length * KilometresPerHour]),
            ("pedal_cc", [Throttle(moment)]),
            ("regen", [null]),
            ("requestedTorqueAfterProc", [null]),
            ("right_solar", [null]),
            ("steer_corrected", [steering]),
            ("steer_offset_can", [0]),
            ("steer_raw", [steering]),
            ("transversal_accel", [moment.Reading.Acceleration.Y / Gravity])
        );
    }

    /// <summary>The range of the sensor in nuScenes is 0.375 to 0.411.</summary>
    private static double BrakeSensor(EgoMotion controls) => 0.375 + (controls.Brake!.Value * (0.411 - 0.375));

    private static double? SteeringDegrees(NuScenesMoment moment) => moment.Reading.Controls?.Steering * FullLock * DegreesPerRadian;

    private static double? Throttle(NuScenesMoment moment) =>
        moment.Reading.Controls is { } controls ? Math.Round(controls.Throttle!.Value * MaxThrottle) : null;

    private static double WheelRpm(NuScenesMoment moment) => moment.Reading.Velocity.X / (2 * Math.PI * WheelRadius) * 60;

    private static double?[] Vector(Vector3D vector) => [vector.X, vector.Y, vector.Z];

    private static double?[] Quaternion(NuScenesMoment moment)
    {
        Rotation rotation = Rotation.OfBody(moment.Reading.Pose.Axes);
        return [rotation.W, rotation.X, rotation.Y, rotation.Z];
    }

    private static NuScenesMessage Of(NuScenesMoment moment, params (string Name, double?[] Values)[] fields) =>
        new(moment.Timestamp, fields);
}
