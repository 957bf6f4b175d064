namespace Harvester.Sessions.Files;

/// <summary>When a writer waits for the disk. docs/dataset-format.md says what is durable when.</summary>
public enum SyncMode
{
    /// <summary>Frames are brought to the disk together, at most 16 or those of one second; then their label lines are written.</summary>
    Batch,

    /// <summary>Every frame is brought to the disk before its label line is written.</summary>
    Always,

    /// <summary>Nothing waits for the disk: a loss of power may take what the operating system has not written yet.</summary>
    Never,
}
