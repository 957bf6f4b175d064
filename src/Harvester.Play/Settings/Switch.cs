namespace Harvester.Play.Settings;

/// <summary>On or off, as the settings say it.</summary>
internal enum Switch
{
    /// <summary>Not done.</summary>
    Off,

    /// <summary>Done.</summary>
    On,
}
