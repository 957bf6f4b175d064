namespace Harvester.Capture.Ports;

/// <summary>Where the list of entities near the camera comes from.</summary>
public enum ListSource
{
    /// <summary>The scripting API's own lists, which are complete.</summary>
    Api,

    /// <summary>The game's natives, which list fewer: used if the API's lists fail.</summary>
    Natives,
}
