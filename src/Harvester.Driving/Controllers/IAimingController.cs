using Harvester.Sessions.Labels;

namespace Harvester.Driving.Controllers;

/// <summary>A controller that tells what it aims at.</summary>
public interface IAimingController : IController
{
    /// <summary>What the last controls aim at; null before the first and if it is unknown.</summary>
    DriveTarget? Target { get; }
}
