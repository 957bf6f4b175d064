namespace Harvester.Play.Tapes;

/// <summary>What is recorded on a tape.</summary>
public enum TapeChoice
{
    /// <summary>Nothing.</summary>
    Off,

    /// <summary>The calls to the game; of pictures a fingerprint each.</summary>
    Natives,

    /// <summary>The calls to the game and the pictures.</summary>
    NativesAndPictures,
}
