namespace Harvester.Cli.Driving;

/// <summary>The controllers that a drive can be driven by.</summary>
internal enum ControllerName
{
    /// <summary>Stanley's law, car following, lane changes.</summary>
    Stanley,

    /// <summary>The controller published with DeepDriving.</summary>
    DeepDriving,
}
