namespace Harvester.ImageLibraries;

/// <summary>What became of damaged files.</summary>
internal sealed class DamageCount
{
    /// <summary>Refused by the exception that the library names.</summary>
    public int Refused { get; set; }

    /// <summary>Ended by another exception.</summary>
    public int OtherExceptions { get; set; }

    /// <summary>Decoded to other pixels, without a word.</summary>
    public int Unnoticed { get; set; }

    /// <summary>Took more than a second.</summary>
    public int Slow { get; set; }

    /// <summary>Allocated more than a gigabyte of managed memory.</summary>
    public int Large { get; set; }
}
