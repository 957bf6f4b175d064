namespace Harvester.Play.Surveys.Paint;

/// <summary>Around what a survey of paint photographs roads.</summary>
public enum SurveyPlace
{
    /// <summary>Around the player.</summary>
    Player,

    /// <summary>Around the places of a plan.</summary>
    Plan,
}
