using Harvester.Sessions.Labels;

namespace Harvester.Driving.Controllers;

/// <summary>A controller that reports its target.</summary>
public interface IAimingController : IController
{
    /// <summary>The target of the last controls; null before the first, and if it is unknown.</summary>
    DriveTarget? Target { get; }
}
