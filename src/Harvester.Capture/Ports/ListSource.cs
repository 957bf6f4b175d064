namespace Harvester.Capture.Ports;

/// <summary>Where the entities near the camera are known from.</summary>
public enum ListSource
{
    /// <summary>The scripting API's own lists, which hold all that exist.</summary>
    Api,

    /// <summary>The game's natives, which know fewer: used where the API's lists fail.</summary>
    Natives,
}
