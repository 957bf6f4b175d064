namespace Harvester.Play.Settings;

/// <summary>A switch in the settings file.</summary>
internal enum Switch
{
    /// <summary>Not done.</summary>
    Off,

    /// <summary>Done.</summary>
    On,
}
