namespace Harvester.Sessions.Labels;

/// <summary>Why a further picture of a moment is missing.</summary>
public enum PairDrop
{
    /// <summary>The picture still changed when the time limit was reached.</summary>
    Unsettled,

    /// <summary>The picture did not change where the objects were hidden.</summary>
    NotHidden,

    /// <summary>The screen gave no usable picture.</summary>
    NoPicture,
}
