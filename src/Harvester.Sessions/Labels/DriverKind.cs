namespace Harvester.Sessions.Labels;

/// <summary>Who drives the ego.</summary>
public enum DriverKind
{
    /// <summary>Nobody: no client has sent anything recently, and the car brakes.</summary>
    None,

    /// <summary>The built-in driver of the game, as in junctions.</summary>
    BuiltIn,

    /// <summary>A controller of this program, by the indicators.</summary>
    Controller,

    /// <summary>A client of the live bridge.</summary>
    Client,
}
