namespace Harvester.Cli.Supervising;

/// <summary>What a supervised program says of itself.</summary>
internal enum HeartbeatState
{
    /// <summary>It is being prepared; no frame is due yet.</summary>
    Starting,

    /// <summary>It takes frames.</summary>
    Running,

    /// <summary>All is done, and it ends.</summary>
    Finished,

    /// <summary>It cannot go on, and ends.</summary>
    Failed,
}
