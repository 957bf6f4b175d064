namespace Harvester.Runs.Tests.Scenarios;

/// <summary>A body at one moment, as the simulated game's truth has it; metres and metres per second on the ground.</summary>
internal readonly record struct SeenBody(
    double X,
    double Y,
    double ForwardX,
    double ForwardY,
    double VelocityX,
    double VelocityY,
    double Front,
    double Rear,
    double HalfWidth
)
{
    public double Speed => Math.Sqrt((VelocityX * VelocityX) + (VelocityY * VelocityY));
}
