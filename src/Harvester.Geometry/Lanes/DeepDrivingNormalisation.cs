namespace Harvester.Geometry.Lanes;

/// <summary>
/// The linear maps with which DeepDriving's loss layer brings indicators into [0.1, 0.9], the range of its network's outputs. They are made
/// for <see cref="TorcsEquivalent"/> values; metric values of wider lanes leave the range.
/// </summary>
public static class DeepDrivingNormalisation
{
    // y = 0.1 + 0.8 (x - min) / (max - min), with the slope and the intercept rounded as in the loss layer, and the ranges of its comments:
    // toMarking_L [-7, -2.5], M [-2, 3.5], R [2.5, 7], LL [-9.5, -4], ML [-5.5, -0.5], MR [0.5, 5.5], RR [4, 9.5]. A distance to a vehicle
    // of 75 m, which stands for none, gives 0.91; the angle is not shifted to 0.1 and is the only value that is clamped.

    /// <summary>Angle in radians; clamped to [0, 1].</summary>
    public static double Angle(double value) => Math.Max(0, Math.Min(1, (value / 1.1) + 0.5));

    /// <summary>Distance to the marking on the left, on marking.</summary>
    public static double ToMarkingL(double value) => (value * 0.17778) + 1.34445;

    /// <summary>Distance to the marking that the car is on.</summary>
    public static double ToMarkingM(double value) => (value * 0.14545) + 0.39091;

    /// <summary>Distance to the marking on the right, on marking.</summary>
    public static double ToMarkingR(double value) => (value * 0.17778) - 0.34445;

    /// <summary>Any distance to a vehicle.</summary>
    public static double Dist(double value) => (value / 95) + 0.12;

    /// <summary>Distance to the left marking of the lane to the left.</summary>
    public static double ToMarkingLL(double value) => (value * 0.14545) + 1.48181;

    /// <summary>Distance to the left marking of the car's lane.</summary>
    public static double ToMarkingML(double value) => (value * 0.16) + 0.98;

    /// <summary>Distance to the right marking of the car's lane.</summary>
    public static double ToMarkingMR(double value) => (value * 0.16) + 0.02;

    /// <summary>Distance to the right marking of the lane to the right.</summary>
    public static double ToMarkingRR(double value) => (value * 0.14545) - 0.48181;

    /// <summary>The fourteenth value: 1 when more than 60 m of straight road lie ahead, else 0.</summary>
    public static double Fast(bool isFast) => isFast ? 0.8 : 0.2;
}
